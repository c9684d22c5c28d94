// The joint distribution of two fields, as IGF-SDF needs it.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/study/histogram.h"

namespace girth::study {

/// A histogram in the plane without its empty cells: what Rubner et al. 2000 call a signature.
struct JointHistogram {
  /// For each cell the mean of the first field's values in it (not the cell's middle).
  std::vector<double> first;
  /// The values of the second field.
  std::vector<double> second;
  /// For each cell its share of the whole.
  std::vector<double> shares;
  /// Whether there is no cell.
  bool empty() const { return shares.empty(); }
};

/// The cells of a joint histogram.
struct JointHistogramOptions {
  /// Cells along each axis, 1 to 1000.
  std::size_t bins{16};
  /// The range of the first field that they cover; values outside count to the cells at the ends.
  HistogramRange first;
  /// The range of the second field.
  HistogramRange second;
};

/// Vertices counted by weight in the cells of (first, second); those that lack one of the values do
/// not count. Cells are in a fixed order; shares add up to 1. O(n + bins²).
GIRTH_EXPORT JointHistogram jointHistogramOf(std::span<const double> first,
                                             std::span<const double> second,
                                             std::span<const double> weights,
                                             const JointHistogramOptions& options);

/// The earth mover's distance with the Euclidean distance in the plane, after each axis has been
/// divided by its scale, as the cost (transport.h). Errors: INVALID_OPTION where one is empty.
GIRTH_EXPORT Result<double> jointDistance(const JointHistogram& one, const JointHistogram& two,
                                          double firstScale, double secondScale);

}  // namespace girth::study
