// The joint distribution of two fields, as IGF-SDF needs it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "girth/error.h"
#include "girth/study/histogram.h"

namespace girth::study {

/// A histogram in the plane without its empty cells: what Rubner et al. 2000 call a signature.
struct JointHistogram {
  /// For each cell the mean of the values in it (not the cell's middle), and its share.
  std::vector<double> first, second, shares;
  bool empty() const { return shares.empty(); }
};

struct JointHistogramOptions {
  /// Cells along each axis, 1 to 1000.
  std::size_t bins{16};
  /// What they cover; values outside count to the cells at the ends.
  HistogramRange first, second;
};

/// Vertices counted by weight in the cells of (first, second); those that lack one of the values do
/// not count. Cells are in a fixed order; shares add up to 1. O(n + bins²).
JointHistogram jointHistogramOf(std::span<const double> first, std::span<const double> second,
                                std::span<const double> weights,
                                const JointHistogramOptions& options);

/// The earth mover's distance with the Euclidean distance in the plane, after each axis has been
/// divided by its scale, as the cost (transport.h). Errors: INVALID_OPTION where one is empty.
Result<double> jointDistance(const JointHistogram& one, const JointHistogram& two,
                             double firstScale, double secondScale);

}  // namespace girth::study
