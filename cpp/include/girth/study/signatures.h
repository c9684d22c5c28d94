// The signatures of a collection of shapes, and the distances between them.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "girth/distribution.h"
#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/study/bag_of_features.h"
#include "girth/study/joint_histogram.h"
#include "girth/study/study_fields.h"

namespace girth::study {

/// The names of the descriptors that stand by themselves: "igf", "igf-ms", "sdf", "geoaverage" and
/// "geofarthest" are distributions of a field; "hks", "sihks" and "wks" are bags of features;
/// "igf-sdf" is the joint distribution of two fields. "log-igf" and so on are the distributions of
/// logarithms: values count by their ratios, and so thin parts as much as thick ones.
GIRTH_EXPORT std::vector<std::string> descriptorNames();

/// A descriptor: one of those above, or a weighted sum of some.
struct Descriptor {
  /// A part of a sum.
  struct Term {
    double weight{1};  ///< factor of its distances
    std::string name;  ///< one of descriptorNames
  };
  /// As it was given.
  std::string name;
  /// The terms that it is the sum of; one or more.
  std::vector<Term> terms;
};

/// "igf", or "igf+sdf", or "2*igf+sdf": the distance is the weighted sum of the terms' distances,
/// each divided by its mean over all pairs of the collection. Errors: USAGE.
GIRTH_EXPORT Result<Descriptor> parseDescriptor(std::string_view text);

/// The groups of fields that descriptors need, each once.
GIRTH_EXPORT std::vector<FieldGroup> groupsOf(const std::vector<Descriptor>& descriptors);

/// The factor that multiplies one-dimensional fields before they are compared.
enum class ValueScale : std::uint8_t {
  AsIs,      ///< nothing: the surface's area is the measure
  Greatest,  ///< each model's greatest value becomes 1 (the paper's Figure 9)
  Span,      ///< each model's least value becomes 0 and its greatest 1
};

/// How signatures are made of fields and compared.
struct SignatureOptions {
  /// Bins of one-dimensional histograms over the values of all models; 0: the exact distance of the
  /// distributions.
  std::size_t bins{0};
  /// The factor of the values.
  ValueScale scale{ValueScale::AsIs};
  /// One-dimensional values are distinguished up to the one that this share (in (0, 1]) of all
  /// models together does not exceed; greater ones count as it: the long loops of plates and tips
  /// then do not outweigh everything else. 1: all are distinguished.
  double axis{1};
  /// Cells along each axis of joint histograms.
  std::size_t jointBins{16};
  /// How the words of bags of features are chosen.
  VocabularyOptions vocabulary;
  /// How a feature counts to the words.
  WordChoice words{WordChoice::Nearest};
  /// Features of each model that the words are chosen among, spread over its vertices.
  std::size_t featuresPerModel{100};
};

/// The signatures of a numbered collection. First every model's fields are handed over (`add`),
/// then `finish` is called once; then, where `needsWords`, every model's fields once more
/// (`addWords`). Different models may be added by different threads at once. Memory in proportion
/// to the models: their one-dimensional fields, not their surfaces.
class GIRTH_EXPORT Signatures {
 public:
  /// `names`: of descriptorNames, each once; `models`: how many will be added.
  Signatures(std::vector<std::string> names, std::size_t models, SignatureOptions options);
  ~Signatures();
  /// Signatures can be moved, not copied.
  Signatures(Signatures&&) noexcept;
  /// Signatures can be assigned by moving.
  Signatures& operator=(Signatures&&) noexcept;

  /// Hands over all fields of a model that its descriptors need (groupsOf).
  void add(std::size_t model, const StudyFields& fields);
  /// Chooses words, and the ranges of histograms. Errors: CANCELLED.
  Result<bool> finish(const ExecutionContext& context = {});
  /// Whether there are bags of features, so that fields are needed once more. After `finish`.
  bool needsWords() const;
  /// Counts a model's features to the words.
  void addWords(std::size_t model, const StudyFields& fields);

  /// How far two models are apart by one of the names. Symmetric; NaN where one of them has no
  /// value at all. May be called by several threads.
  double distance(std::string_view name, std::size_t one, std::size_t two) const;

  /// The distribution of a one-dimensional descriptor; null for the others, and once `finish` has
  /// turned distributions into histograms.
  const Distribution* distributionOf(std::string_view name, std::size_t model) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace girth::study
