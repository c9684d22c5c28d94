// Distances by descriptors that are sums of others.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "girth/execution.h"
#include "girth/export.h"
#include "girth/study/pair_distances.h"
#include "girth/study/signatures.h"

namespace girth::study {

/// The names that descriptors are made of, each once, in alphabetical order.
GIRTH_EXPORT std::vector<std::string> termsOf(const std::vector<Descriptor>& descriptors);

/// One descriptor's distances, row by row, from the distances by its terms: each divided by its
/// mean over all pairs, times its weight; a single term of weight 1 is taken as it is.
class GIRTH_EXPORT DescriptorRows {
 public:
  /// `terms` has the distances, prepared, by every name in the descriptor, and must outlive this.
  DescriptorRows(Descriptor descriptor, const std::map<std::string, PairDistances>& terms,
                 std::size_t models);
  /// The distances must outlive this: keep them in a variable.
  DescriptorRows(Descriptor, const std::map<std::string, PairDistances>&&,
                 std::size_t models) = delete;

  /// All distances of a model, one for each model. False if cancelled.
  bool row(std::size_t model, std::vector<double>& row, const ExecutionContext& context = {});

 private:
  Descriptor descriptor_;
  const std::map<std::string, PairDistances>& terms_;
  std::vector<double> part_;
};

}  // namespace girth::study
