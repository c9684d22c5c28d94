// Several numbers for every vertex.
#pragma once

#include <cstddef>
#include <vector>

namespace girth {

/// Numbers of every vertex, the same count for each.
struct VertexSignatures {
  /// How many numbers a vertex has.
  std::size_t dimensions{0};
  /// The numbers of vertex v are values[v · dimensions + d].
  std::vector<double> values;
};

}  // namespace girth
