#include "girth/study/joint_histogram.h"

#include <algorithm>
#include <cmath>

#include "girth/study/transport.h"

namespace girth::study {

JointHistogram jointHistogramOf(std::span<const double> first, std::span<const double> second,
                                std::span<const double> weights,
                                const JointHistogramOptions& options) {
  const std::size_t bins = std::clamp<std::size_t>(options.bins, 1, 1000);
  const auto binOf = [&](double value, const HistogramRange& range) {
    const double bin =
        std::floor((value - range.low) / (range.high - range.low) * static_cast<double>(bins));
    return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(bins - 1)));
  };
  struct Cell {
    double first{0}, second{0}, weight{0};
  };
  std::vector<Cell> cells(bins * bins);
  double sum = 0;
  for (std::size_t v = 0; v < weights.size(); ++v) {
    if (!std::isfinite(first[v]) || !std::isfinite(second[v]) || !(weights[v] > 0)) continue;
    Cell& cell = cells[binOf(first[v], options.first) * bins + binOf(second[v], options.second)];
    cell.first += weights[v] * first[v];
    cell.second += weights[v] * second[v];
    cell.weight += weights[v];
    sum += weights[v];
  }
  JointHistogram histogram;
  for (const Cell& cell : cells) {
    if (cell.weight == 0) continue;
    histogram.first.push_back(cell.first / cell.weight);
    histogram.second.push_back(cell.second / cell.weight);
    histogram.shares.push_back(cell.weight / sum);
  }
  return histogram;
}

Result<double> jointDistance(const JointHistogram& one, const JointHistogram& two,
                             double firstScale, double secondScale) {
  std::vector<double> costs;
  costs.reserve(one.shares.size() * two.shares.size());
  for (std::size_t i = 0; i < one.shares.size(); ++i) {
    for (std::size_t j = 0; j < two.shares.size(); ++j) {
      const double x = (one.first[i] - two.first[j]) / firstScale;
      const double y = (one.second[i] - two.second[j]) / secondScale;
      costs.push_back(std::sqrt(x * x + y * y));
    }
  }
  return transportCost(one.shares, two.shares, costs);
}

}  // namespace girth::study
