// The models of a study and their distances to each other: fields computed or taken from the cache,
// signatures made of them, what failed left out.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "girth/study/pair_distances.h"
#include "girth/study/signatures.h"
#include "model/model_options.h"
#include "study/collection.h"
#include "study/comparison.h"
#include "study/field_cache.h"
#include "study/shard.h"

namespace girth::cli {

struct StudyModels {
  /// Models that have fields; their classes are numbers in `classes`, which has none without
  /// models.
  std::vector<CollectionModel> models;
  std::vector<std::string> classes;
  /// Models that were left out, by name, and why.
  std::vector<std::pair<std::string, std::string>> failed;
  /// Other faults and their consequences, one line each.
  std::vector<std::string> notes;
  /// The distances of `models` by each of the descriptors' terms.
  std::map<std::string, study::PairDistances> distances;
  /// Models, each content once, and fields of them that were computed and taken from the cache.
  std::size_t contents{0}, computed{0}, taken{0};
};

/// Computes the fields that are not in the cache, and the signatures. A share of the work computes
/// only the fields: `models`, `classes` and `distances` stay empty. Failures and notes are also
/// printed on standard error. Errors: CANCELLED; the fields computed so far are in the cache.
Result<StudyModels> loadStudyModels(const Collection& collection,
                                    const std::vector<study::Descriptor>& descriptors,
                                    const ModelOptions& preparing, const ComparisonOptions& options,
                                    const FieldCache& cache, const Shard& shard);

}  // namespace girth::cli
