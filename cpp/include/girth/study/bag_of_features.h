// Bags of features: what many-valued signatures of vertices are compared by.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"

namespace girth::study {

/// How words are chosen.
struct VocabularyOptions {
  /// Words: the paper takes 48.
  std::size_t words{48};
  /// A seed; one seed always gives the same words.
  std::uint64_t seed{1};
  /// Rounds of Lloyd's algorithm at most; it ends when no feature changes its word.
  unsigned rounds{50};
};

/// The words that features are replaced by.
struct Vocabulary {
  /// Numbers of a word.
  std::size_t dimensions{0};
  /// Word w: words[w · dimensions + d].
  std::vector<double> words;
  /// Twice the median distance of a word to its nearest other word: the width that Shape Google
  /// gives its soft words. 0 with one word.
  double width{0};

  /// How many words there are.
  std::size_t size() const { return dimensions == 0 ? 0 : words.size() / dimensions; }
};

/// Chooses words among `features` (feature i: features[i · dimensions + d]), each counted by its
/// weight: k-means++ (Arthur and Vassilvitskii 2007), then Lloyd's rounds. Features that are not
/// finite do not count. Fewer distinct features than words: as many words as there are. Any number
/// of threads gives the same words. O(rounds · n · words · dimensions).
///
/// Errors: INVALID_OPTION (no words, no dimensions, sizes that do not fit, no feature left),
/// CANCELLED.
GIRTH_EXPORT Result<Vocabulary> vocabularyOf(std::span<const double> features,
                                             std::size_t dimensions,
                                             std::span<const double> weights,
                                             const VocabularyOptions& options = {},
                                             const ExecutionContext& context = {});

/// How a feature counts to the words.
enum class WordChoice : std::uint8_t {
  Nearest,  ///< all to the nearest one
  Soft,  ///< to each by exp(−d²/2w²), w the vocabulary's width, adding up to 1 (Bronstein et al.
         ///< 2011, section 4.1)
};

/// How much of the features' weight each word has; adds up to 1 (all 0 without any feature that
/// counts). O(n · words · dimensions).
GIRTH_EXPORT std::vector<double> bagOfFeatures(const Vocabulary& vocabulary,
                                               std::span<const double> features,
                                               std::span<const double> weights, WordChoice choice);

/// The sum of the differences of two bags: 0 to 2. NaN where one is all 0.
GIRTH_EXPORT double bagDistance(std::span<const double> one, std::span<const double> two);

}  // namespace girth::study
