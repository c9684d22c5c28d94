// Times and their distribution.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <utility>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::bench {

/// Seconds that a call takes by the wall clock.
template <class Call>
double secondsOf(Call&& call) {
  const auto start = std::chrono::steady_clock::now();
  std::forward<Call>(call)();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Seconds of processor time that a call on one thread takes: what it would take by the wall clock
/// on a machine that does nothing else.
template <class Call>
double processorSecondsOf(Call&& call) {
  const std::clock_t start = std::clock();
  std::forward<Call>(call)();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The value that a share of the others does not exceed; 0.5: the median.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank),
                   values.end());
  return values[rank];
}

/// `count` vertices spread evenly over the numbers; all of them where there are fewer.
inline std::vector<Index> spreadVertices(const SurfaceMesh& mesh, std::size_t count) {
  const std::size_t all = mesh.vertexCount();
  count = std::min(count, all);
  std::vector<Index> vertices;
  for (std::size_t i = 0; i < count; ++i) {
    vertices.push_back(static_cast<Index>((2 * i + 1) * all / (2 * count)));
  }
  return vertices;
}

}  // namespace girth::bench
