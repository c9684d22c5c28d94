// Several numbers for every vertex.
#pragma once

#include <cstddef>
#include <vector>

namespace girth {

/// The same count of numbers for every vertex.
struct VertexSignatures {
  /// How many numbers a vertex has.
  std::size_t dimensions{0};
  /// Of vertex v: values[v · dimensions + d].
  std::vector<double> values;
};

}  // namespace girth
