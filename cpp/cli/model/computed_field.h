// A field with its own memory, as commands compute it.
#pragma once

#include <string>
#include <vector>

namespace girth::cli {

struct ComputedField {
  /// As in io::VertexField.
  std::string name, method, unit;
  std::vector<double> values;
};

}  // namespace girth::cli
