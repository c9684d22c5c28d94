// Several numbers for every vertex.
#pragma once

#include <cstddef>
#include <vector>

namespace girth {

struct VertexSignatures {
  /// Numbers for each vertex.
  std::size_t dimensions{0};
  /// Of vertex v: values[v · dimensions + d].
  std::vector<double> values;
};

}  // namespace girth
