#include "girth/distribution.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "no_value.h"

namespace girth {

Distribution distributionOf(std::span<const double> values, std::span<const double> weights) {
  std::vector<std::pair<double, double>> steps;
  steps.reserve(values.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (!std::isfinite(values[v]) || !(weights[v] > 0)) continue;
    steps.emplace_back(values[v], weights[v]);
  }
  std::sort(steps.begin(), steps.end());
  double sum = 0;
  for (const auto& step : steps) sum += step.second;
  Distribution distribution;
  distribution.values.reserve(steps.size());
  distribution.shares.reserve(steps.size());
  for (const auto& [value, weight] : steps) {
    distribution.values.push_back(value);
    distribution.shares.push_back(weight / sum);
  }
  return distribution;
}

double earthMoversDistance(const Distribution& one, const Distribution& two) {
  if (one.empty() || two.empty()) return kNoValue;
  // Both distributions are stairs: their difference changes only at values.
  double difference = 0, integral = 0, last = std::min(one.values[0], two.values[0]);
  for (std::size_t i = 0, j = 0; i < one.values.size() || j < two.values.size();) {
    const bool first =
        j == two.values.size() || (i < one.values.size() && one.values[i] <= two.values[j]);
    const double value = first ? one.values[i] : two.values[j];
    integral += std::fabs(difference) * (value - last);
    last = value;
    difference += first ? one.shares[i++] : -two.shares[j++];
  }
  return integral;
}

}  // namespace girth
