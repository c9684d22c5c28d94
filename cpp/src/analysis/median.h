// Middle values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace girth {

/// The middle one of some values, or the mean of the two in the middle. At least one value.
inline double medianOf(std::vector<double> values) {
  const std::size_t n = values.size();
  std::sort(values.begin(), values.end());
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

}  // namespace girth
