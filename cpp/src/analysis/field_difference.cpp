#include "girth/field_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "girth/vertex_areas.h"

namespace girth {

namespace {

/// Values in order, each with its share of the area.
std::vector<std::pair<double, double>> distributionOf(const SurfaceMesh& mesh,
                                                      std::span<const double> values) {
  const std::vector<double> areas = vertexAreas(mesh);
  const double scale = std::sqrt(mesh.area());
  std::vector<std::pair<double, double>> steps;
  double sum = 0;
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (std::isnan(values[v])) continue;
    steps.emplace_back(values[v] / scale, areas[v]);
    sum += areas[v];
  }
  std::sort(steps.begin(), steps.end());
  for (auto& step : steps) step.second /= sum;
  return steps;
}

}  // namespace

double fieldDifference(const SurfaceMesh& mesh1, std::span<const double> values1,
                       const SurfaceMesh& mesh2, std::span<const double> values2) {
  const auto one = distributionOf(mesh1, values1), two = distributionOf(mesh2, values2);
  if (one.empty() || two.empty()) return std::numeric_limits<double>::quiet_NaN();
  // Both distributions are stairs: their difference changes only at values.
  double difference = 0, integral = 0, last = std::min(one[0].first, two[0].first);
  for (std::size_t i = 0, j = 0; i < one.size() || j < two.size();) {
    const bool first = j == two.size() || (i < one.size() && one[i].first <= two[j].first);
    const auto& [value, share] = first ? one[i++] : two[j++];
    integral += std::fabs(difference) * (value - last);
    last = value;
    difference += first ? share : -share;
  }
  return integral;
}

}  // namespace girth
