#include "solver/refined/girth_audit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace girth {

namespace {

/// Values that differ by less, as shares, are equal.
constexpr double kEqual = 1e-6;

}  // namespace

GirthAudit auditOf(std::span<const double> found, std::span<const double> exact) {
  GirthAudit result;
  std::vector<double> differences;
  for (std::size_t i = 0; i < found.size(); ++i) {
    differences.push_back(std::isnan(found[i]) ? 1 : std::fabs(found[i] / exact[i] - 1));
    if (differences.back() <= kEqual) ++result.equal;
  }
  if (differences.empty()) return result;
  std::sort(differences.begin(), differences.end());
  const std::size_t last = differences.size() - 1;
  result.vertices = static_cast<Index>(differences.size());
  result.median = differences[last / 2];
  result.percentile95 = differences[std::min(last, differences.size() * 95 / 100)];
  result.greatest = differences[last];
  // Wilson's interval, for 95 %.
  constexpr double z = 1.959963984540054;
  const double n = result.vertices, share = result.equal / n;
  const double centre = (share + z * z / (2 * n)) / (1 + z * z / n);
  const double reach =
      z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  result.atLeast = std::clamp(centre - reach, 0.0, share);
  result.atMost = std::clamp(centre + reach, share, 1.0);
  return result;
}

}  // namespace girth
