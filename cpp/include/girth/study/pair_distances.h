// Distances between all pairs of a collection, row by row, however many there are.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "girth/execution.h"
#include "girth/export.h"

namespace girth::study {

/// Rows of a symmetric matrix of distances with zeros on its diagonal. Up to `kKept` models every
/// pair is computed once and kept (8 bytes a pair); beyond that rows are computed when they are
/// asked for and nothing is kept, so that memory stays in proportion to the models.
class GIRTH_EXPORT PairDistances {
 public:
  /// Models up to which all pairs are kept.
  static constexpr std::size_t kKept = 3000;
  /// How far two models are apart, by their numbers.
  using Distance = std::function<double(std::size_t one, std::size_t two)>;

  /// `distance` must be safe to call from several threads.
  PairDistances(std::size_t models, Distance distance, std::size_t kept = kKept);

  /// Computes all pairs that are kept, and the mean: over all pairs, or where they are not kept
  /// over those of 64 rows spread evenly. False if cancelled.
  bool prepare(const ExecutionContext& context);

  /// All distances of a model; `row` has room for every model. False if cancelled.
  bool row(std::size_t model, std::span<double> row, const ExecutionContext& context = {}) const;
  /// The mean over pairs of different models, leaving NaN out; 0 where there is none.
  double mean() const { return mean_; }

 private:
  std::size_t models_;
  Distance distance_;
  bool keeps_;
  /// The distance of pair (i, j), j < i, at i (i − 1) / 2 + j.
  std::vector<double> pairs_;
  double mean_{0};
};

}  // namespace girth::study
