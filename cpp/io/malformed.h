// The error of a reader that finds its file's format broken.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "girth/error.h"

namespace girth::io {

/// `place`: the element, line or byte that is wrong, as the reader counts them; -1 for none.
inline Error malformed(std::int64_t place, std::string message) {
  return makeError(ErrorCode::MalformedFile, place, std::move(message));
}

}  // namespace girth::io
