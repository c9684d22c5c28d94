#include "retrieval/common_quantile.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace girth::study {

double commonQuantile(std::span<const Distribution> distributions, double share) {
  std::vector<std::pair<double, double>> steps;
  double sum = 0;
  for (const Distribution& distribution : distributions) {
    for (std::size_t i = 0; i < distribution.values.size(); ++i) {
      steps.emplace_back(distribution.values[i], distribution.shares[i]);
      sum += distribution.shares[i];
    }
  }
  if (steps.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(steps.begin(), steps.end());
  double reached = 0;
  for (const auto& [value, part] : steps) {
    reached += part;
    if (reached >= share * sum) return value;
  }
  return steps.back().first;
}

void capValues(Distribution& distribution, double greatest) {
  auto& [values, shares] = distribution;
  // They rise: all that is too great is at the end, and becomes one step.
  const auto first = std::upper_bound(values.begin(), values.end(), greatest) - values.begin();
  const auto kept = static_cast<std::size_t>(first);
  if (kept == values.size()) return;
  double rest = 0;
  for (std::size_t i = kept; i < shares.size(); ++i) rest += shares[i];
  values.resize(kept);
  shares.resize(kept);
  values.push_back(greatest);
  shares.push_back(rest);
}

}  // namespace girth::study
