#include "analysis/otsu.h"

#include <algorithm>

namespace girth {

std::optional<double> bestDivision(std::vector<WeightedValue> values, double least) {
  std::sort(values.begin(), values.end(),
            [](const WeightedValue& a, const WeightedValue& b) { return a.value < b.value; });
  double weight = 0, mean = 0, variance = 0;
  for (const WeightedValue& v : values) weight += v.weight;
  for (const WeightedValue& v : values) mean += v.weight / weight * v.value;
  for (const WeightedValue& v : values) {
    variance += v.weight / weight * (v.value - mean) * (v.value - mean);
  }
  double below = 0, sum = 0, best = least * variance;
  std::optional<double> division;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    below += values[i].weight / weight;
    sum += values[i].weight / weight * values[i].value;
    if (!(values[i].value < values[i + 1].value) || !(below > 0 && below < 1)) continue;
    // below (1 − below) (difference of the means)².
    const double difference = mean * below - sum;
    const double between = difference * difference / (below * (1 - below));
    if (!(between > best)) continue;
    best = between;
    division = (values[i].value + values[i + 1].value) / 2;
  }
  return division;
}

}  // namespace girth
