#include "girth/study/histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace girth::study {

std::vector<double> histogramOf(const Distribution& distribution, const HistogramRange& range,
                                std::size_t bins) {
  std::vector<double> shares(std::max<std::size_t>(1, bins), 0);
  const double last = static_cast<double>(shares.size() - 1);
  const double perUnit = static_cast<double>(shares.size()) / (range.high - range.low);
  for (std::size_t i = 0; i < distribution.values.size(); ++i) {
    const double bin = std::floor((distribution.values[i] - range.low) * perUnit);
    shares[static_cast<std::size_t>(std::clamp(bin, 0.0, last))] += distribution.shares[i];
  }
  return shares;
}

double histogramDistance(const std::vector<double>& one, const std::vector<double>& two,
                         const HistogramRange& range) {
  const auto isEmpty = [](const std::vector<double>& shares) {
    return std::all_of(shares.begin(), shares.end(), [](double share) { return share == 0; });
  };
  if (one.size() != two.size() || isEmpty(one) || isEmpty(two)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double difference = 0, sum = 0;
  for (std::size_t bin = 0; bin < one.size(); ++bin) {
    difference += one[bin] - two[bin];
    sum += std::fabs(difference);
  }
  return sum * (range.high - range.low) / static_cast<double>(one.size());
}

}  // namespace girth::study
