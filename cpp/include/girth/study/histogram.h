// Histograms of one field, as the paper compares them.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstddef>
#include <vector>

#include "girth/distribution.h"
#include "girth/export.h"

namespace girth::study {

/// The range that the bins of a histogram cover; `low` < `high`.
struct HistogramRange {
  double low{0};   ///< where the first bin begins
  double high{1};  ///< where the last bin ends
};

/// The shares of the values in `bins` bins of equal width (the paper: 512); what lies outside the
/// range counts to the bin at its end. Adds up to 1; all 0 where the distribution is empty. At
/// least one bin. O(n).
GIRTH_EXPORT std::vector<double> histogramOf(const Distribution& distribution,
                                             const HistogramRange& range, std::size_t bins = 512);

/// The earth mover's distance of two histograms over the same range, a bin's share lying in its
/// middle: the sum of |CDF1 − CDF2| over the bins, times their width. NaN where one is empty. Off
/// from that of the distributions by at most the width of a bin. O(bins).
GIRTH_EXPORT double histogramDistance(const std::vector<double>& one,
                                      const std::vector<double>& two, const HistogramRange& range);

}  // namespace girth::study
