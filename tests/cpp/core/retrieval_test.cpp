// Comparing shapes: distributions, transport, words and measures against what is known by hand, and
// against slow ways that are plainly right.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "girth/distribution.h"
#include "girth/study/bag_of_features.h"
#include "girth/study/histogram.h"
#include "girth/study/joint_histogram.h"
#include "girth/study/measures.h"
#include "girth/study/pair_distances.h"
#include "girth/study/signatures.h"
#include "girth/study/study_fields.h"
#include "girth/study/transport.h"
#include "retrieval/common_quantile.h"
#include "shapes.h"

namespace girth::study {
namespace {

using girth::test::Random;
using Numbers = std::vector<double>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Numbers randomNumbers(Random& random, std::size_t count) {
  Numbers numbers(count);
  for (double& number : numbers) number = random();
  return numbers;
}

TEST(Distribution, DistanceByHand) {
  // All at 1 against half at 0 and half at 4: half moves by 1, half by 3.
  const auto one = distributionOf(Numbers{1}, Numbers{7});
  const auto two = distributionOf(Numbers{4, 0}, Numbers{2, 2});
  EXPECT_DOUBLE_EQ(earthMoversDistance(one, two), 2);
  EXPECT_DOUBLE_EQ(earthMoversDistance(two, one), 2);
  EXPECT_EQ(earthMoversDistance(two, two), 0);
}

TEST(Distribution, WhatHasNoValueOrNoWeightDoesNotCount) {
  const auto plain = distributionOf(Numbers{1, 3}, Numbers{1, 1});
  const auto spoilt =
      distributionOf(Numbers{kNaN, 3, 1, 9, kInfinity, -5}, Numbers{4, 1, 1, 0, 2, kNaN});
  EXPECT_EQ(earthMoversDistance(plain, spoilt), 0);
  const auto none = distributionOf(Numbers{kNaN}, Numbers{1});
  EXPECT_TRUE(none.empty());
  EXPECT_TRUE(std::isnan(earthMoversDistance(plain, none)));
}

TEST(Distribution, IsTheTransportOnTheLine) {
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    const Numbers a = randomNumbers(random, 1 + random.below(7));
    const Numbers b = randomNumbers(random, 1 + random.below(7));
    const Numbers supplies = randomNumbers(random, a.size());
    const Numbers demands = randomNumbers(random, b.size());
    Numbers costs;
    for (const double x : a) {
      for (const double y : b) costs.push_back(std::fabs(x - y));
    }
    const auto moved = transportCost(supplies, demands, costs);
    ASSERT_TRUE(moved.ok());
    EXPECT_NEAR(moved.value(),
                earthMoversDistance(distributionOf(a, supplies), distributionOf(b, demands)), 1e-8);
  }
}

TEST(Distribution, CommonQuantileByHand) {
  // Each counts alike, however many values it has: 1, 2 and 3, 4 are a quarter each.
  const std::vector<Distribution> all{distributionOf(Numbers{4, 3}, Numbers{1, 1}),
                                      distributionOf(Numbers{1, 2, 2}, Numbers{2, 1, 1}),
                                      Distribution{}};
  EXPECT_EQ(commonQuantile(all, 0.2), 1);
  EXPECT_EQ(commonQuantile(all, 0.5), 2);
  EXPECT_EQ(commonQuantile(all, 0.6), 3);
  EXPECT_EQ(commonQuantile(all, 1), 4);
  EXPECT_TRUE(std::isnan(commonQuantile(std::vector<Distribution>(2), 0.5)));
}

TEST(Distribution, CappedValuesCountAsTheGreatest) {
  Random random(11);
  for (int round = 0; round < 50; ++round) {
    Numbers values = randomNumbers(random, 1 + random.below(20));
    const Numbers weights(values.size(), 1);
    const double greatest = random();
    Distribution capped = distributionOf(values, weights);
    capValues(capped, greatest);
    for (double& value : values) value = std::min(value, greatest);
    EXPECT_NEAR(earthMoversDistance(capped, distributionOf(values, weights)), 0, 1e-15);
    EXPECT_NEAR(std::accumulate(capped.shares.begin(), capped.shares.end(), 0.0), 1, 1e-12);
  }
}

TEST(Histogram, BinsAndDistanceByHand) {
  const auto distribution = distributionOf(Numbers{-1, 0, 0.49, 0.5, 1, 7}, Numbers(6, 1.0));
  const auto shares = histogramOf(distribution, {0, 1}, 2);
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_DOUBLE_EQ(shares[0], 0.5) << "below the range counts to the first bin";
  EXPECT_DOUBLE_EQ(shares[1], 0.5) << "above it to the last";
  EXPECT_DOUBLE_EQ(histogramDistance({1, 0, 0}, {0, 0, 1}, {0, 6}), 4) << "two bins of width 2";
  EXPECT_TRUE(std::isnan(histogramDistance({0, 0}, {1, 0}, {0, 1})));
}

TEST(Histogram, DistanceIsNearThatOfTheDistributions) {
  Random random(2);
  for (int round = 0; round < 20; ++round) {
    const auto one = distributionOf(randomNumbers(random, 300), randomNumbers(random, 300));
    const auto two = distributionOf(randomNumbers(random, 200), randomNumbers(random, 200));
    const double exact = earthMoversDistance(one, two);
    const double binned =
        histogramDistance(histogramOf(one, {0, 1}), histogramOf(two, {0, 1}), {0, 1});
    EXPECT_NEAR(binned, exact, 1.0 / 512);
  }
}

/// The least cost over all basic solutions of the linear programme: every choice of n + m − 1 arcs
/// whose flows can be told one after another, from nodes with one arc left.
double leastCostOfAllBases(const Numbers& supplies, const Numbers& demands, const Numbers& costs) {
  const std::size_t n = supplies.size(), m = demands.size(), arcs = n * m;
  double best = kInfinity;
  for (std::size_t choice = 0; choice < (std::size_t{1} << arcs); ++choice) {
    if (static_cast<std::size_t>(__builtin_popcountll(choice)) != n + m - 1) continue;
    std::size_t left = choice;
    Numbers rest = supplies;
    rest.insert(rest.end(), demands.begin(), demands.end());
    double cost = 0;
    bool feasible = true;
    for (bool found = true; found && left != 0 && feasible;) {
      found = false;
      for (std::size_t node = 0; node < n + m && feasible; ++node) {
        std::size_t degree = 0, only = 0;
        for (std::size_t arc = 0; arc < arcs; ++arc) {
          if ((left >> arc & 1) == 0 || (arc / m != node && n + arc % m != node)) continue;
          ++degree;
          only = arc;
        }
        if (degree != 1) continue;
        found = true;
        const double flow = rest[node];
        feasible = flow >= -1e-12;
        cost += flow * costs[only];
        rest[only / m] -= flow;
        rest[n + only % m] -= flow;
        left &= ~(std::size_t{1} << only);
      }
    }
    feasible = feasible && left == 0 &&
               std::all_of(rest.begin(), rest.end(), [](double r) { return std::fabs(r) < 1e-9; });
    if (feasible) best = std::min(best, cost);
  }
  return best;
}

Numbers scaledToOne(Numbers masses) {
  const double sum = std::accumulate(masses.begin(), masses.end(), 0.0);
  for (double& mass : masses) mass /= sum;
  return masses;
}

TEST(Transport, AgreesWithAllBases) {
  Random random(3);
  for (int round = 0; round < 60; ++round) {
    const std::size_t n = 1 + random.below(3), m = 1 + random.below(4);
    const Numbers supplies = scaledToOne(randomNumbers(random, n));
    const Numbers demands = scaledToOne(randomNumbers(random, m));
    Numbers costs = randomNumbers(random, n * m);
    if (round % 3 == 0) {
      for (double& cost : costs) cost = std::floor(3 * cost);  // many equal ones
    }
    const auto cost = transportCost(supplies, demands, costs);
    ASSERT_TRUE(cost.ok());
    EXPECT_NEAR(cost.value(), leastCostOfAllBases(supplies, demands, costs), 1e-8);
  }
}

TEST(Transport, EqualSharesAreADegenerateProblem) {
  // An assignment: every basis has arcs without flow, where a careless simplex runs in circles.
  Random random(4);
  for (int round = 0; round < 20; ++round) {
    const Numbers equal(3, 1.0 / 3);
    Numbers costs = randomNumbers(random, 9);
    for (double& cost : costs) cost = std::floor(2 * cost);
    const auto cost = transportCost(equal, equal, costs);
    ASSERT_TRUE(cost.ok());
    EXPECT_NEAR(cost.value(), leastCostOfAllBases(equal, equal, costs), 1e-9);
  }
  const std::size_t n = 60;
  Numbers costs(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) costs[i * n + j] = (i + j) % n == 0 ? 0 : 1;
  }
  const auto cost = transportCost(Numbers(n, 1), Numbers(n, 1), costs);
  ASSERT_TRUE(cost.ok());
  EXPECT_NEAR(cost.value(), 0, 1e-12);
}

TEST(Transport, KnowsItsOwnOptimum) {
  // Moving a cloud by a vector: no cheaper way than straight, whatever the shares.
  Random random(5);
  const std::size_t n = 80;
  const Numbers x = randomNumbers(random, n), y = randomNumbers(random, n);
  const Numbers shares = randomNumbers(random, n);
  Numbers costs;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      costs.push_back(std::hypot(x[i] - x[j] - 3, y[i] - y[j] - 4));
  }
  const auto cost = transportCost(shares, shares, costs);
  ASSERT_TRUE(cost.ok());
  EXPECT_NEAR(cost.value(), 5, 1e-8);
}

TEST(Transport, RefusesWhatIsNoProblem) {
  const auto refused = [](const Numbers& supplies, const Numbers& demands, const Numbers& costs) {
    const auto cost = transportCost(supplies, demands, costs);
    return !cost.ok() && cost.error().code == ErrorCode::InvalidOption;
  };
  EXPECT_TRUE(refused({1}, {1}, {}));
  EXPECT_TRUE(refused({1}, {-1, 2}, {1, 1}));
  EXPECT_TRUE(refused({0}, {1}, {1}));
  EXPECT_TRUE(refused({kNaN}, {1}, {1}));
  EXPECT_TRUE(refused({1}, {1}, {kInfinity}));
  EXPECT_TRUE(refused({1}, {1}, {-1}));
  EXPECT_TRUE(refused({}, {}, {}));
}

TEST(JointHistogram, DistanceOfShiftedCopies) {
  Random random(6);
  const Numbers x = randomNumbers(random, 200), y = randomNumbers(random, 200);
  const Numbers weights = randomNumbers(random, 200);
  Numbers shifted = x;
  for (double& value : shifted) value += 2;
  const JointHistogramOptions options{8, {0, 1}, {0, 1}};
  const JointHistogramOptions shiftedOptions{8, {2, 3}, {0, 1}};
  const auto one = jointHistogramOf(x, y, weights, options);
  const auto two = jointHistogramOf(shifted, y, weights, shiftedOptions);
  EXPECT_LE(one.shares.size(), 64u);
  EXPECT_NEAR(std::accumulate(one.shares.begin(), one.shares.end(), 0.0), 1, 1e-12);
  const auto distance = jointDistance(one, two, 0.5, 1);
  ASSERT_TRUE(distance.ok());
  EXPECT_NEAR(distance.value(), 4, 1e-7);
  EXPECT_FALSE(jointDistance(one, JointHistogram{}, 1, 1).ok());
}

/// Four clouds of different sizes round the corners of a square.
Numbers fourClouds(Random& random, std::size_t count) {
  Numbers features;
  for (std::size_t i = 0; i < count; ++i) {
    features.push_back((i % 4 < 2 ? 0 : 10) + random());
    features.push_back((i % 2 == 0 ? 0 : 10) + random());
  }
  return features;
}

TEST(BagOfFeatures, FindsClouds) {
  Random random(7);
  const Numbers features = fourClouds(random, 400);
  const Numbers weights(400, 1);
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto vocabulary = vocabularyOf(features, 2, weights, {4, seed, 100});
    ASSERT_TRUE(vocabulary.ok());
    ASSERT_EQ(vocabulary.value().size(), 4u);
    EXPECT_NEAR(vocabulary.value().width, 20, 1);
    const auto bag = bagOfFeatures(vocabulary.value(), features, weights, WordChoice::Nearest);
    for (const double share : bag) EXPECT_DOUBLE_EQ(share, 0.25);
  }
}

TEST(BagOfFeatures, IsRepeatableForAnyNumberOfThreads) {
  Random random(8);
  const Numbers features = randomNumbers(random, 3 * 2000), weights = randomNumbers(random, 2000);
  ExecutionContext one, three;
  one.threads = 1;
  three.threads = 3;
  const auto a = vocabularyOf(features, 3, weights, {20, 5, 30}, one);
  const auto b = vocabularyOf(features, 3, weights, {20, 5, 30}, three);
  const auto c = vocabularyOf(features, 3, weights, {20, 6, 30}, three);
  ASSERT_TRUE(a.ok() && b.ok() && c.ok());
  EXPECT_EQ(a.value().words, b.value().words);
  EXPECT_NE(a.value().words, c.value().words);
}

TEST(BagOfFeatures, WeightsAreCopies) {
  Random random(9);
  Numbers features = fourClouds(random, 8), twice;
  for (std::size_t i = 0; i < 8; ++i) {
    for (int copy = 0; copy < (i == 3 ? 5 : 1); ++copy) {
      twice.insert(twice.end(), {features[2 * i], features[2 * i + 1]});
    }
  }
  Numbers weights(8, 1);
  weights[3] = 5;
  const auto vocabulary = vocabularyOf(features, 2, weights, {3, 1, 100}).value();
  for (const WordChoice choice : {WordChoice::Nearest, WordChoice::Soft}) {
    const auto one = bagOfFeatures(vocabulary, features, weights, choice);
    const auto two = bagOfFeatures(vocabulary, twice, Numbers(12, 1), choice);
    EXPECT_NEAR(bagDistance(one, two), 0, 1e-12);
    EXPECT_NEAR(std::accumulate(one.begin(), one.end(), 0.0), 1, 1e-12);
  }
}

TEST(BagOfFeatures, FewFeaturesGiveFewWords) {
  const Numbers features{1, 1, 2, kNaN}, weights{1, 1, 1, 1};
  const auto vocabulary = vocabularyOf(features, 1, weights);
  ASSERT_TRUE(vocabulary.ok());
  EXPECT_EQ(vocabulary.value().size(), 2u);
  EXPECT_FALSE(vocabularyOf(Numbers{kNaN}, 1, Numbers{1}).ok());
  EXPECT_FALSE(vocabularyOf(features, 3, weights).ok());
  EXPECT_FALSE(vocabularyOf(features, 1, weights, {0, 1, 1}).ok());
  EXPECT_TRUE(std::isnan(bagDistance(Numbers{0, 0}, Numbers{0, 1})));
}

TEST(Measures, HandWorkedExample) {
  // Model 0 is asked for; its class has 0, 1, 2 and 3. In the order of distance: 1 x 2 x x 3 x.
  const std::vector<std::uint32_t> classes{0, 0, 0, 0, 1, 1, 1, 1};
  const Numbers distances{0, 1, 3, 6, 2, 4, 5, 7};
  const auto ranking = rankingOf(0, distances, classes);
  EXPECT_EQ(ranking, (std::vector<std::uint32_t>{1, 4, 2, 5, 6, 3, 7}));
  const RetrievalMeasures measures = measuresOf(0, ranking, classes);
  EXPECT_DOUBLE_EQ(measures.nearestNeighbour, 1);
  EXPECT_DOUBLE_EQ(measures.firstTier, 2.0 / 3);
  EXPECT_DOUBLE_EQ(measures.secondTier, 1);
  // Only 7 can be retrieved: P = 3/7, R = 1; with the query P = 4/8, R = 1.
  EXPECT_DOUBLE_EQ(measures.eMeasure, 2 / (7.0 / 3 + 1));
  EXPECT_DOUBLE_EQ(measures.eMeasureWithQuery, 2 / (2.0 + 1));
  EXPECT_DOUBLE_EQ(measures.discountedGain,
                   (1 + 1 / std::log2(3.0) + 1 / std::log2(6.0)) / (1 + 1 + 1 / std::log2(3.0)));
  EXPECT_DOUBLE_EQ(measures.precision[0], 1) << "one of three at the first place";
  EXPECT_DOUBLE_EQ(measures.precision[5], 1) << "recall 0.30 is one of three";
  EXPECT_DOUBLE_EQ(measures.precision[6], 2.0 / 3) << "recall 0.35 is two of three, at place 3";
  EXPECT_DOUBLE_EQ(measures.precision[19], 0.5) << "all three at place 6";
}

TEST(Measures, LimitsOfTwentyAClass) {
  // web/docs/definitions.md, section 6: 74.5% without the query, 76.9% with it.
  std::vector<std::uint32_t> classes;
  for (std::uint32_t i = 0; i < 600; ++i) classes.push_back(i / 20);
  Numbers distances(600);
  for (std::size_t i = 0; i < 600; ++i) distances[i] = static_cast<double>(i);
  const auto perfect = measuresOf(0, rankingOf(0, distances, classes), classes);
  EXPECT_DOUBLE_EQ(perfect.eMeasure, 38.0 / 51);
  EXPECT_DOUBLE_EQ(perfect.eMeasureWithQuery, 40.0 / 52);
  EXPECT_DOUBLE_EQ(perfect.discountedGain, 1);
  EXPECT_DOUBLE_EQ(perfect.firstTier, 1);
  EXPECT_DOUBLE_EQ(perfect.precision[19], 1);
}

TEST(Measures, TiesGainNothingAndUnknownComesLast) {
  const std::vector<std::uint32_t> classes{0, 0, 1, 1, 0};
  EXPECT_EQ(rankingOf(0, Numbers{0, 1, 1, 1, 1}, classes),
            (std::vector<std::uint32_t>{2, 3, 1, 4}));
  EXPECT_EQ(rankingOf(0, Numbers{0, kNaN, 5, kInfinity, kNaN}, classes),
            (std::vector<std::uint32_t>{2, 3, 1, 4}));
}

/// The measures as sets and sums, straight from the definitions.
RetrievalMeasures slowMeasures(std::size_t query, const Numbers& distances,
                               const std::vector<std::uint32_t>& classes) {
  const std::size_t n = classes.size();
  const auto nearer = [&](std::size_t a, std::size_t b) {
    if (distances[a] != distances[b]) return distances[a] < distances[b];
    const bool inA = classes[a] == classes[query], inB = classes[b] == classes[query];
    return inA != inB ? inB : a < b;
  };
  // The place of a model is one more than the number of models before it.
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < n; ++i) {
    if (i == query || classes[i] != classes[query]) continue;
    std::size_t place = 1;
    for (std::size_t j = 0; j < n; ++j) place += j != query && j != i && nearer(j, i) ? 1 : 0;
    places.push_back(place);
  }
  std::sort(places.begin(), places.end());
  const auto within = [&](std::size_t k) {
    return static_cast<double>(
        std::count_if(places.begin(), places.end(), [&](std::size_t p) { return p <= k; }));
  };
  RetrievalMeasures measures;
  const auto others = static_cast<double>(places.size());
  if (places.empty()) return measures;
  measures.nearestNeighbour = within(1);
  measures.firstTier = within(places.size()) / others;
  measures.secondTier = within(2 * places.size()) / others;
  const auto harmonic = [](double precision, double recall) {
    return precision == 0 ? 0 : 2 / (1 / precision + 1 / recall);
  };
  const double retrieved = std::min<double>(32, static_cast<double>(n) - 1);
  measures.eMeasure = harmonic(within(32) / retrieved, within(32) / others);
  const double withQuery = std::min<double>(32, static_cast<double>(n));
  measures.eMeasureWithQuery =
      harmonic((within(31) + 1) / withQuery, (within(31) + 1) / (others + 1));
  double gained = 0, best = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto gainAt = [](std::size_t place) {
      return place < 2 ? 1.0 : std::log(2.0) / std::log(static_cast<double>(place));
    };
    gained += gainAt(places[i]);
    best += gainAt(i + 1);
  }
  measures.discountedGain = gained / best;
  for (std::size_t level = 1; level <= 20; ++level) {
    const auto needed = (level * places.size() + 19) / 20;
    measures.precision[level - 1] =
        static_cast<double>(needed) / static_cast<double>(places[needed - 1]);
  }
  return measures;
}

TEST(Measures, AgreeWithAnIndependentImplementationOnRandomRankings) {
  Random random(10);
  for (int round = 0; round < 200; ++round) {
    const std::size_t n = 2 + random.below(90);
    const Index classCount = 1 + random.below(8);
    std::vector<std::uint32_t> classes(n);
    Numbers distances(n);
    for (std::size_t i = 0; i < n; ++i) {
      classes[i] = random.below(classCount);
      distances[i] = round % 2 == 0 ? random() : random.below(6);  // with ties
    }
    const std::size_t query = random.below(static_cast<Index>(n));
    const auto fast = measuresOf(query, rankingOf(query, distances, classes), classes);
    const auto slow = slowMeasures(query, distances, classes);
    EXPECT_DOUBLE_EQ(fast.nearestNeighbour, slow.nearestNeighbour);
    EXPECT_DOUBLE_EQ(fast.firstTier, slow.firstTier);
    EXPECT_DOUBLE_EQ(fast.secondTier, slow.secondTier);
    EXPECT_DOUBLE_EQ(fast.eMeasure, slow.eMeasure);
    EXPECT_DOUBLE_EQ(fast.eMeasureWithQuery, slow.eMeasureWithQuery);
    EXPECT_NEAR(fast.discountedGain, slow.discountedGain, 1e-12);
    for (std::size_t i = 0; i < 20; ++i) EXPECT_DOUBLE_EQ(fast.precision[i], slow.precision[i]);
  }
}

TEST(Measures, MeanLeavesOutClassesOfOne) {
  const std::vector<std::uint32_t> classes{0, 0, 1, 2, 2, 2};
  MeanMeasures mean(classes);
  EXPECT_EQ(mean.mean().firstTier, 0);
  Random random(11);
  double sum = 0;
  for (std::size_t query = 0; query < classes.size(); ++query) {
    const auto measures = mean.add(query, randomNumbers(random, classes.size()));
    if (query != 2) sum += measures.discountedGain;
    EXPECT_EQ(mean.counts(query), query != 2);
  }
  EXPECT_EQ(mean.queries(), 5u);
  EXPECT_NEAR(mean.mean().discountedGain, sum / 5, 1e-12);
}

TEST(PairDistances, RowsAreTheSameWhetherKeptOrNot) {
  const std::size_t n = 57;
  const auto distance = [](std::size_t a, std::size_t b) {
    EXPECT_NE(a, b);
    return a + b == 5 ? kNaN : 1 + std::fabs(static_cast<double>(a) - static_cast<double>(b));
  };
  PairDistances kept(n, distance), computed(n, distance, 0);
  ExecutionContext context;
  context.threads = 3;
  ASSERT_TRUE(kept.prepare(context));
  ASSERT_TRUE(computed.prepare(context));
  EXPECT_NEAR(kept.mean(), computed.mean(), 1e-12) << "all rows are sampled where there are few";
  Numbers one(n), two(n);
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_TRUE(kept.row(i, one) && computed.row(i, two, context));
    EXPECT_EQ(one[i], 0);
    for (std::size_t j = 0; j < n; ++j) {
      EXPECT_TRUE(one[j] == two[j] || (std::isnan(one[j]) && std::isnan(two[j])));
    }
  }
  std::atomic<bool> cancel{true};
  context.cancel = &cancel;
  EXPECT_FALSE(kept.prepare(context));
  EXPECT_FALSE(computed.row(0, one, context));
  PairDistances alone(1, distance);
  EXPECT_TRUE(alone.prepare({}));
  EXPECT_EQ(alone.mean(), 0);
}

TEST(Descriptor, SumsAndWeights) {
  const auto sum = parseDescriptor("2.5*log-igf+sdf");
  ASSERT_TRUE(sum.ok());
  ASSERT_EQ(sum.value().terms.size(), 2u);
  EXPECT_EQ(sum.value().terms[0].name, "log-igf");
  EXPECT_DOUBLE_EQ(sum.value().terms[0].weight, 2.5);
  EXPECT_EQ(groupsOf({sum.value()}),
            (std::vector<FieldGroup>{FieldGroup::Girth, FieldGroup::Diameter}));
  for (const char* wrong : {"", "+", "igf+", "igf++sdf", "*igf", "0*igf", "-1*igf", "1e3*igf",
                            "nan*igf", "99999999*igf", "2*", "IGF", "log-wks", "igf sdf"}) {
    const auto descriptor = parseDescriptor(wrong);
    ASSERT_FALSE(descriptor.ok()) << wrong;
    EXPECT_EQ(descriptor.error().code, ErrorCode::Usage);
  }
  for (const std::string& name : descriptorNames()) EXPECT_TRUE(parseDescriptor(name).ok()) << name;
}

TEST(Signatures, TellShapesApartWhateverTheirSize) {
  // Two boxes alike but for their size, and one that is longer.
  const std::vector<SurfaceMesh> meshes{test::box(4, 1, 1, 8, 2, 2).mesh(),
                                        test::box(8, 2, 2, 8, 2, 2).mesh(),
                                        test::box(4, 3, 1, 8, 6, 2).mesh()};
  for (const std::size_t bins : {0, 512}) {
    SignatureOptions options;
    options.bins = bins;
    Signatures signatures(descriptorNames(), meshes.size(), options);
    std::vector<StudyFields> all(meshes.size());
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const auto surface = studySurface(meshes[m], {});
      ASSERT_TRUE(surface.ok());
      EXPECT_NEAR(surface.value().area(), 1, 1e-12);
      for (const FieldGroup group : kFieldGroups) {
        auto fields = studyFields(surface.value(), group, {});
        ASSERT_TRUE(fields.ok()) << toString(group);
        EXPECT_NEAR(
            std::accumulate(fields.value().weights.begin(), fields.value().weights.end(), 0.0), 1,
            1e-12);
        all[m].weights = fields.value().weights;
        for (const StudyField& field : fields.value().fields) all[m].fields.push_back(field);
      }
      signatures.add(m, all[m]);
    }
    EXPECT_NE(signatures.distributionOf("igf", 0), nullptr);
    ASSERT_TRUE(signatures.finish().ok());
    EXPECT_EQ(signatures.distributionOf("igf", 0) != nullptr, bins == 0);
    EXPECT_EQ(signatures.distributionOf("wks", 0), nullptr);
    ASSERT_TRUE(signatures.needsWords());
    for (std::size_t m = 0; m < meshes.size(); ++m) signatures.addWords(m, all[m]);
    for (const std::string& name : descriptorNames()) {
      EXPECT_LT(signatures.distance(name, 0, 1), 1e-9) << name;
      EXPECT_GT(signatures.distance(name, 0, 2), 1e-3) << name;
      EXPECT_EQ(signatures.distance(name, 0, 2), signatures.distance(name, 2, 0)) << name;
    }
    EXPECT_TRUE(std::isnan(signatures.distance("nothing", 0, 1)));
  }
}

TEST(Signatures, GreaterValuesThanTheAxisHasCountAlike) {
  // Nine tenths of each model's area are at 1; the last tenth lies at 2, 3 and 9.
  const auto fieldsWith = [](double last) {
    StudyFields fields;
    fields.weights = Numbers{0.9, 0.1};
    fields.fields.push_back({"igf", 1, Numbers{1, last}});
    return fields;
  };
  for (const double axis : {1.0, 0.95, 0.9}) {
    SignatureOptions options;
    options.axis = axis;
    Signatures signatures({"igf", "log-igf"}, 3, options);
    signatures.add(0, fieldsWith(2));
    signatures.add(1, fieldsWith(3));
    signatures.add(2, fieldsWith(9));
    ASSERT_TRUE(signatures.finish().ok());
    // The value that 95% of all do not exceed is 3, and 90%: 1.
    const double greatest = axis == 1 ? 9 : axis == 0.95 ? 3 : 1;
    EXPECT_NEAR(signatures.distance("igf", 0, 1),
                0.1 * (std::min(3.0, greatest) - std::min(2.0, greatest)), 1e-15);
    EXPECT_NEAR(signatures.distance("igf", 0, 2), 0.1 * (greatest - std::min(2.0, greatest)),
                1e-15);
    EXPECT_NEAR(signatures.distance("log-igf", 0, 2),
                0.1 * std::log(greatest / std::min(2.0, greatest)), 1e-15);
  }
}

TEST(Signatures, LogarithmsAreOfTheScaledValues) {
  // Below 1 logarithms are negative: the greatest of them is no scale. The models are multiples of
  // each other, but for the last.
  SignatureOptions options;
  options.scale = ValueScale::Greatest;
  Signatures signatures({"igf", "log-igf"}, 3, options);
  const std::vector<Numbers> values{{0.1, 0.2, 0.4}, {0.2, 0.4, 0.8}, {0.1, 0.1, 0.4}};
  for (std::size_t m = 0; m < values.size(); ++m) {
    StudyFields fields;
    fields.weights = Numbers{0.25, 0.5, 0.25};
    fields.fields.push_back({"igf", 1, values[m]});
    signatures.add(m, fields);
  }
  ASSERT_TRUE(signatures.finish().ok());
  EXPECT_NEAR(signatures.distance("igf", 0, 1), 0, 1e-15);
  EXPECT_NEAR(signatures.distance("log-igf", 0, 1), 0, 1e-15);
  EXPECT_NEAR(signatures.distance("igf", 0, 2), 0.5 * 0.25, 1e-15);
  EXPECT_NEAR(signatures.distance("log-igf", 0, 2), 0.5 * std::log(2.0), 1e-15);
}

TEST(StudyFields, ProgressOfTheSurfaceNeverFalls) {
  FieldParameters parameters;
  parameters.faces = 500;
  parameters.smoothing = 3;
  std::vector<double> shares;
  const ExecutionContext context{1, nullptr, [&](double share) { shares.push_back(share); }};
  ASSERT_TRUE(studySurface(test::icosphere(4).mesh(), parameters, context).ok());
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1);
}

TEST(StudyFields, LargerSurfacesAreRemeshedSmallerOnesAreNot) {
  const SurfaceMesh fine = test::icosphere(4).mesh();  // 5,120 faces
  FieldParameters parameters;
  parameters.faces = 1000;
  const auto remeshed = studySurface(fine, parameters);
  ASSERT_TRUE(remeshed.ok());
  EXPECT_NEAR(remeshed.value().faceCount(), 1000, 20);
  EXPECT_NEAR(remeshed.value().area(), 1, 1e-12);
  for (const Index faces : {0u, 5120u, 10'000u}) {
    parameters.faces = faces;
    EXPECT_EQ(studySurface(fine, parameters).value().faceCount(), 5120u);
  }
  parameters = {};
  parameters.diameter.rays = 31;
  EXPECT_NE(parametersText(FieldGroup::Diameter, {}),
            parametersText(FieldGroup::Diameter, parameters));
  FieldParameters persistent;
  persistent.persistence = 0.02;
  EXPECT_NE(parametersText(FieldGroup::Girth, {}), parametersText(FieldGroup::Girth, persistent));
  EXPECT_EQ(parametersText(FieldGroup::Extent, {}), parametersText(FieldGroup::Extent, persistent));
  EXPECT_EQ(parametersText(FieldGroup::Girth, {}), parametersText(FieldGroup::Girth, parameters))
      << "the girth does not depend on rays";
}

}  // namespace
}  // namespace girth::study
