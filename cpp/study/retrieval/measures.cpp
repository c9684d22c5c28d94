#include "girth/study/measures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace girth::study {

namespace {

/// The E-measure looks at so many.
constexpr std::size_t kRetrieved = 32;

/// The weight of place i, from 1.
double gain(std::size_t place) {
  return place == 1 ? 1 : 1 / std::log2(static_cast<double>(place));
}

double share(std::size_t part, std::size_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

RetrievalMeasures& RetrievalMeasures::operator+=(const RetrievalMeasures& other) {
  nearestNeighbour += other.nearestNeighbour;
  firstTier += other.firstTier;
  secondTier += other.secondTier;
  eMeasure += other.eMeasure;
  eMeasureWithQuery += other.eMeasureWithQuery;
  discountedGain += other.discountedGain;
  for (std::size_t i = 0; i < precision.size(); ++i) precision[i] += other.precision[i];
  return *this;
}

RetrievalMeasures& RetrievalMeasures::operator/=(double count) {
  for (double* value : {&nearestNeighbour, &firstTier, &secondTier, &eMeasure, &eMeasureWithQuery,
                        &discountedGain}) {
    *value /= count;
  }
  for (double& value : precision) value /= count;
  return *this;
}

std::vector<std::uint32_t> rankingOf(std::size_t query, std::span<const double> distances,
                                     std::span<const std::uint32_t> classes) {
  std::vector<std::uint32_t> ranking;
  ranking.reserve(distances.size());
  for (std::uint32_t i = 0; i < distances.size(); ++i) {
    if (i != query) ranking.push_back(i);
  }
  std::sort(ranking.begin(), ranking.end(), [&](std::uint32_t a, std::uint32_t b) {
    const bool unknownA = std::isnan(distances[a]), unknownB = std::isnan(distances[b]);
    if (unknownA != unknownB) return unknownB;
    if (!unknownA && distances[a] != distances[b]) return distances[a] < distances[b];
    const bool foundA = classes[a] == classes[query], foundB = classes[b] == classes[query];
    return foundA != foundB ? foundB : a < b;
  });
  return ranking;
}

RetrievalMeasures measuresOf(std::size_t query, std::span<const std::uint32_t> ranking,
                             std::span<const std::uint32_t> classes) {
  RetrievalMeasures measures;
  const auto wanted = static_cast<std::size_t>(
      std::count_if(ranking.begin(), ranking.end(),
                    [&](std::uint32_t model) { return classes[model] == classes[query]; }));
  if (wanted == 0) return measures;
  const std::size_t retrieved = std::min(kRetrieved, ranking.size());
  const std::size_t retrievedWithQuery = std::min(kRetrieved, ranking.size() + 1);
  std::size_t found = 0, level = 0;
  double best = 0;
  for (std::size_t place = 1; place <= ranking.size(); ++place) {
    if (classes[ranking[place - 1]] == classes[query]) {
      ++found;
      measures.discountedGain += gain(place);
      best += gain(found);
      // The levels of recall that this model brings.
      while (level < measures.precision.size() &&
             (level + 1) * wanted <= found * measures.precision.size()) {
        measures.precision[level++] = share(found, place);
      }
    }
    if (place == 1) measures.nearestNeighbour = static_cast<double>(found);
    if (place <= wanted) measures.firstTier = share(found, wanted);
    if (place <= 2 * wanted) measures.secondTier = share(found, wanted);
    if (place <= retrieved) measures.eMeasure = share(2 * found, retrieved + wanted);
    if (place + 1 <= retrievedWithQuery) {
      measures.eMeasureWithQuery = share(2 * (found + 1), retrievedWithQuery + wanted + 1);
    }
  }
  measures.discountedGain /= best;
  return measures;
}

MeanMeasures::MeanMeasures(std::vector<std::uint32_t> classes) : classes_(std::move(classes)) {
  for (const std::uint32_t one : classes_) {
    if (one >= sizes_.size()) sizes_.resize(one + std::size_t{1}, 0);
    ++sizes_[one];
  }
}

RetrievalMeasures MeanMeasures::add(std::size_t query, std::span<const double> distances) {
  const RetrievalMeasures measures =
      measuresOf(query, rankingOf(query, distances, classes_), classes_);
  if (counts(query)) {
    sum_ += measures;
    ++queries_;
  }
  return measures;
}

RetrievalMeasures MeanMeasures::mean() const {
  RetrievalMeasures mean = sum_;
  if (queries_ > 0) mean /= static_cast<double>(queries_);
  return mean;
}

}  // namespace girth::study
