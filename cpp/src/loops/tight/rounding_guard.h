// Where rounding alone decides about steps: vertices that a curve passes again and again without
// getting shorter.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_set>

#include "geodesic/tolerances.h"
#include "girth/elements.h"

namespace girth::loops {

/// Watches a curve that is drawn tight. Beside an end that lies at a vertex but for rounding,
/// angles are noise. When many steps in a row have not made the curve shorter, the vertices of
/// these steps stay as they are, until it gets shorter again.
class RoundingGuard {
 public:
  bool isSettled(Index vertex) const { return settled_.count(vertex) > 0; }

  /// Notes a step at a vertex. `size`: of the curve; `length()`: its length, asked for seldom.
  template <class Length>
  void passed(Index vertex, std::size_t size, Length length) {
    passed_.insert(vertex);
    if (++steps_ < kSteps + 2 * size) return;
    const double now = length();
    if (now < last_ * (1 - geodesic::kRounding)) {
      settled_.clear();
    } else {
      settled_.insert(passed_.begin(), passed_.end());
    }
    last_ = std::min(last_, now);
    steps_ = 0;
    passed_.clear();
  }

 private:
  static constexpr std::size_t kSteps = 64;

  std::unordered_set<Index> settled_, passed_;
  double last_{std::numeric_limits<double>::max()};
  std::size_t steps_{0};
};

}  // namespace girth::loops
