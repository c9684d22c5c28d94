#include "girth/study/bag_of_features.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "girth/parallel.h"
#include "random.h"

namespace girth::study {

namespace {

constexpr std::size_t kFeaturesAtATime = 256;

/// Four sums at a time, which a processor adds side by side; the same order everywhere.
double squaredDistance(const double* a, const double* b, std::size_t dimensions) {
  double sums[4] = {0, 0, 0, 0};
  std::size_t d = 0;
  for (; d + 4 <= dimensions; d += 4) {
    for (std::size_t k = 0; k < 4; ++k) sums[k] += (a[d + k] - b[d + k]) * (a[d + k] - b[d + k]);
  }
  for (; d < dimensions; ++d) sums[0] += (a[d] - b[d]) * (a[d] - b[d]);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// The squared distance, or, where it is not below `enough`, any number of at least `enough`.
double squaredDistanceBelow(const double* a, const double* b, std::size_t dimensions,
                            double enough) {
  constexpr std::size_t kStretch = 16;
  double sum = 0;
  for (std::size_t d = 0; d < dimensions; d += kStretch) {
    sum += squaredDistance(a + d, b + d, std::min(kStretch, dimensions - d));
    if (sum >= enough) break;
  }
  return sum;
}

bool isFinite(const double* feature, std::size_t dimensions) {
  return std::all_of(feature, feature + dimensions, [](double x) { return std::isfinite(x); });
}

/// The nearest word, of equals the first, and its squared distance.
std::pair<std::size_t, double> nearestWord(const Vocabulary& vocabulary, const double* feature) {
  std::pair<std::size_t, double> nearest{0, std::numeric_limits<double>::infinity()};
  for (std::size_t w = 0; w < vocabulary.size(); ++w) {
    const double distance =
        squaredDistanceBelow(feature, vocabulary.words.data() + w * vocabulary.dimensions,
                             vocabulary.dimensions, nearest.second);
    if (distance < nearest.second) nearest = {w, distance};
  }
  return nearest;
}

double widthOf(const Vocabulary& vocabulary) {
  std::vector<double> nearest;
  for (std::size_t a = 0; a < vocabulary.size(); ++a) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < vocabulary.size(); ++b) {
      if (a == b) continue;
      least = std::min(least, squaredDistance(vocabulary.words.data() + a * vocabulary.dimensions,
                                              vocabulary.words.data() + b * vocabulary.dimensions,
                                              vocabulary.dimensions));
    }
    nearest.push_back(std::sqrt(least));
  }
  if (nearest.size() < 2) return 0;
  std::nth_element(nearest.begin(),
                   nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2),
                   nearest.end());
  return 2 * nearest[nearest.size() / 2];
}

/// The features that count, and k-means on them.
class Clustering {
 public:
  Clustering(std::span<const double> features, std::size_t dimensions,
             std::span<const double> weights)
      : dimensions_(dimensions) {
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double* feature = features.data() + i * dimensions;
      if (!(weights[i] > 0) || !isFinite(feature, dimensions)) continue;
      features_.push_back(feature);
      weights_.push_back(weights[i]);
    }
    word_.assign(features_.size(), 0);
    distance_.assign(features_.size(), std::numeric_limits<double>::infinity());
  }

  bool empty() const { return features_.empty(); }

  /// k-means++: each further word is a feature drawn by its weight times the squared distance from
  /// the words before.
  bool seed(std::size_t words, Random& random, const ExecutionContext& context) {
    vocabulary_.dimensions = dimensions_;
    std::size_t chosen = drawn(random, [&](std::size_t i) { return weights_[i]; });
    while (true) {
      const double* word = features_[chosen];
      vocabulary_.words.insert(vocabulary_.words.end(), word, word + dimensions_);
      const bool done =
          parallelFor(features_.size(), kFeaturesAtATime, quietly(context),
                      [&](std::size_t begin, std::size_t end) {
                        for (std::size_t i = begin; i < end; ++i) {
                          distance_[i] = std::min(distance_[i],
                                                  squaredDistance(features_[i], word, dimensions_));
                        }
                      });
      if (!done) return false;
      if (vocabulary_.size() == words) return true;
      chosen = drawn(random, [&](std::size_t i) { return weights_[i] * distance_[i]; });
      if (distance_[chosen] == 0) return true;  // every feature is a word already
    }
  }

  bool refine(unsigned rounds, const ExecutionContext& context) {
    for (unsigned round = 0; round < rounds; ++round) {
      std::atomic<bool> changed{round == 0};
      const bool done = parallelFor(features_.size(), kFeaturesAtATime, quietly(context),
                                    [&](std::size_t begin, std::size_t end) {
                                      for (std::size_t i = begin; i < end; ++i) {
                                        const auto [word, distance] =
                                            nearestWord(vocabulary_, features_[i]);
                                        if (word != word_[i]) changed = true;
                                        word_[i] = word;
                                        distance_[i] = distance;
                                      }
                                    });
      if (!done) return false;
      if (!changed) return true;
      moveToMeans();
      if (context.onProgress) context.onProgress((round + 1.0) / rounds);
    }
    return true;
  }

  Vocabulary take() {
    vocabulary_.width = widthOf(vocabulary_);
    return std::move(vocabulary_);
  }

 private:
  /// Progress is reported by rounds.
  static ExecutionContext quietly(const ExecutionContext& context) {
    return {context.threads, context.cancel, {}};
  }

  /// A feature at random, each as likely as it counts.
  template <class Count>
  std::size_t drawn(Random& random, Count count) const {
    double sum = 0;
    for (std::size_t i = 0; i < features_.size(); ++i) sum += count(i);
    const double target = random() * sum;
    double before = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i < features_.size(); ++i) {
      if (count(i) == 0) continue;
      last = i;
      before += count(i);
      if (before > target) break;
    }
    return last;
  }

  /// In the order of the features, so that sums do not depend on threads. A word that has lost all
  /// its features becomes the feature farthest from its own word.
  void moveToMeans() {
    std::vector<double> sums(vocabulary_.words.size(), 0), weights(vocabulary_.size(), 0);
    for (std::size_t i = 0; i < features_.size(); ++i) {
      weights[word_[i]] += weights_[i];
      for (std::size_t d = 0; d < dimensions_; ++d) {
        sums[word_[i] * dimensions_ + d] += weights_[i] * features_[i][d];
      }
    }
    for (std::size_t w = 0; w < vocabulary_.size(); ++w) {
      double* word = vocabulary_.words.data() + w * dimensions_;
      if (weights[w] == 0) {
        const auto farthest = std::max_element(distance_.begin(), distance_.end());
        const double* feature = features_[static_cast<std::size_t>(farthest - distance_.begin())];
        std::copy(feature, feature + dimensions_, word);
        *farthest = 0;
        continue;
      }
      for (std::size_t d = 0; d < dimensions_; ++d)
        word[d] = sums[w * dimensions_ + d] / weights[w];
    }
  }

  std::size_t dimensions_;
  std::vector<const double*> features_;
  std::vector<double> weights_, distance_;
  std::vector<std::size_t> word_;
  Vocabulary vocabulary_;
};

}  // namespace

Result<Vocabulary> vocabularyOf(std::span<const double> features, std::size_t dimensions,
                                std::span<const double> weights, const VocabularyOptions& options,
                                const ExecutionContext& context) {
  if (options.words == 0 || dimensions == 0 || features.size() != weights.size() * dimensions) {
    return makeError(ErrorCode::InvalidOption, -1,
                     "a vocabulary needs words, dimensions, and a weight for every feature");
  }
  Clustering clustering(features, dimensions, weights);
  if (clustering.empty()) {
    return makeError(ErrorCode::InvalidOption, -1, "there is no feature to choose words from");
  }
  Random random(options.seed);
  if (!clustering.seed(options.words, random, context) ||
      !clustering.refine(options.rounds, context)) {
    return makeError(ErrorCode::Cancelled, -1, "stopped before the words were chosen");
  }
  return clustering.take();
}

std::vector<double> bagOfFeatures(const Vocabulary& vocabulary, std::span<const double> features,
                                  std::span<const double> weights, WordChoice choice) {
  std::vector<double> bag(vocabulary.size(), 0), likeness(vocabulary.size());
  const std::size_t dimensions = vocabulary.dimensions;
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double* feature = features.data() + i * dimensions;
    if (!(weights[i] > 0) || !isFinite(feature, dimensions)) continue;
    sum += weights[i];
    const auto [nearest, least] = nearestWord(vocabulary, feature);
    if (choice == WordChoice::Nearest || vocabulary.width == 0) {
      bag[nearest] += weights[i];
      continue;
    }
    double whole = 0;
    for (std::size_t w = 0; w < vocabulary.size(); ++w) {
      const double distance =
          squaredDistance(feature, vocabulary.words.data() + w * dimensions, dimensions);
      // Less the least, which scaling takes out again: so the nearest counts 1, however far it is.
      likeness[w] = std::exp((least - distance) / (2 * vocabulary.width * vocabulary.width));
      whole += likeness[w];
    }
    for (std::size_t w = 0; w < vocabulary.size(); ++w) bag[w] += weights[i] * likeness[w] / whole;
  }
  if (sum > 0) {
    for (double& share : bag) share /= sum;
  }
  return bag;
}

double bagDistance(std::span<const double> one, std::span<const double> two) {
  const auto isEmpty = [](std::span<const double> bag) {
    return std::all_of(bag.begin(), bag.end(), [](double share) { return share == 0; });
  };
  if (one.size() != two.size() || isEmpty(one) || isEmpty(two)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double sum = 0;
  for (std::size_t w = 0; w < one.size(); ++w) sum += std::fabs(one[w] - two[w]);
  return sum;
}

}  // namespace girth::study
