// Notes on the colours that a file has for its vertices.
#pragma once

#include <string>

namespace girth::io {

/// A note for ReadModel, whether or not ReadOptions ask for attributes.
inline std::string coloursNote() {
  return "The colours of its vertices are kept where it is cut, and nowhere else.";
}

}  // namespace girth::io
