// How good a ranking is: the measures of Shilane, Min, Kazhdan and Funkhouser, "The Princeton Shape
// Benchmark", 2004, section 4, as the paper's section 6.1 uses them.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "girth/export.h"

namespace girth::study {

/// All shares in [0, 1]. C: the size of the query's class, the query among it; of the C − 1 others,
/// those found among the first k of the ranking are r(k). The query itself is never in the ranking.
struct GIRTH_EXPORT RetrievalMeasures {
  /// Nearest neighbour: r(1).
  double nearestNeighbour{0};
  /// First tier: r(C − 1) / (C − 1).
  double firstTier{0};
  /// Second tier: r(2(C − 1)) / (C − 1).
  double secondTier{0};
  /// E-measure of the first 32: 2 / (1/P + 1/R) with precision P = r(32)/32 and recall R =
  /// r(32)/(C − 1), that is 2 r(32) / (32 + C − 1). At most 74.5% with 20 models a class.
  double eMeasure{0};
  /// The E-measure with the query counted as found in the first place, and in its class: 2 (r(31) +
  /// 1) / (32 + C). At most 76.9% with 20 models a class; the paper's 75.94% for SIHKS must be
  /// this.
  double eMeasureWithQuery{0};
  /// Discounted cumulative gain over the whole ranking, 1 for the first place and 1 / log2(i) for
  /// place i from 2, divided by that of a perfect ranking.
  double discountedGain{0};
  /// Precision at the places where 1/20, 2/20, … 20/20 of the class (rounded up to whole models)
  /// have been found: the precision-recall curve.
  std::array<double, 20> precision{};

  /// Adds another query's, measure by measure.
  RetrievalMeasures& operator+=(const RetrievalMeasures& other);
  /// Divides every measure.
  RetrievalMeasures& operator/=(double count);
};

/// The models but the query in rising order of their distances. At equal distances, models of other
/// classes come first, so that a descriptor that distinguishes nothing gains nothing; NaN comes
/// last. Among models still equal, the lower number comes first. O(n log n).
GIRTH_EXPORT std::vector<std::uint32_t> rankingOf(std::size_t query,
                                                  std::span<const double> distances,
                                                  std::span<const std::uint32_t> classes);

/// The measures of one query. All 0 where its class has no other model, as it cannot be asked for:
/// leave it out of means. Fewer than 32 models in the ranking: E is of those there are.
GIRTH_EXPORT RetrievalMeasures measuresOf(std::size_t query, std::span<const std::uint32_t> ranking,
                                          std::span<const std::uint32_t> classes);

/// The mean over all models of classes of two or more, every query counting the same (Shilane et
/// al.'s micro-average), by adding up row after row.
class GIRTH_EXPORT MeanMeasures {
 public:
  /// `classes`: of each model the number of its class.
  explicit MeanMeasures(std::vector<std::uint32_t> classes);

  /// One query's distances to all models. Returns its measures.
  RetrievalMeasures add(std::size_t query, std::span<const double> distances);
  /// Whether the query's class has another model.
  bool counts(std::size_t query) const { return sizes_[classes_[query]] > 1; }

  /// How many queries that count were added.
  std::size_t queries() const { return queries_; }
  /// All 0 before the first query that counts.
  RetrievalMeasures mean() const;

 private:
  std::vector<std::uint32_t> classes_;
  std::vector<std::size_t> sizes_;
  std::size_t queries_{0};
  RetrievalMeasures sum_;
};

}  // namespace girth::study
