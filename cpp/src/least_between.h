// The least value of a function of one number between two others.
#pragma once

#include <cmath>
#include <utility>

namespace girth {

/// An argument and the value there.
struct LeastValue {
  double at{0}, value{0};
};

/// A local minimum of a function between `from` and `to`, from `start` on; the ends themselves are
/// not asked for. By parabolas through three points, and by golden sections where these do not help
/// (Brent 1973, "Algorithms for Minimization without Derivatives", chapter 5). The function may be
/// infinite. The argument is exact to `tolerance`; about ten values where the function is smooth,
/// at most a hundred.
template <class Function>
LeastValue leastBetween(Function function, double from, double to, double start, double tolerance) {
  constexpr int kMostSteps = 100;
  const double golden = (3 - std::sqrt(5.0)) / 2;
  LeastValue best{start, function(start)}, second = best, third = best;
  double step = 0, before = 0;
  for (int i = 1; i < kMostSteps; ++i) {
    const double middle = (from + to) / 2;
    if (std::fabs(best.at - middle) <= 2 * tolerance - (to - from) / 2) break;
    // The parabola's lowest place is best.at + p / q.
    const double r = (best.at - second.at) * (best.value - third.value);
    const double s = (best.at - third.at) * (best.value - second.value);
    double p = (best.at - third.at) * s - (best.at - second.at) * r, q = 2 * (s - r);
    if (q > 0) p = -p;
    q = std::fabs(q);
    const double last = std::exchange(before, step);
    if (std::fabs(p) < std::fabs(q * last / 2) && p > q * (from - best.at) &&
        p < q * (to - best.at)) {
      step = p / q;
      const double next = best.at + step;
      if (next - from < 2 * tolerance || to - next < 2 * tolerance) {
        step = best.at < middle ? tolerance : -tolerance;
      }
    } else {
      before = best.at < middle ? to - best.at : from - best.at;
      step = golden * before;
    }
    if (std::fabs(step) < tolerance) step = step > 0 ? tolerance : -tolerance;
    const double at = best.at + step;
    const LeastValue next{at, function(at)};
    if (next.value <= best.value) {
      (at < best.at ? to : from) = best.at;
      third = std::exchange(second, std::exchange(best, next));
      continue;
    }
    (at < best.at ? from : to) = at;
    if (next.value <= second.value || second.at == best.at) {
      third = std::exchange(second, next);
    } else if (next.value <= third.value || third.at == best.at || third.at == second.at) {
      third = next;
    }
  }
  return best;
}

}  // namespace girth
