#include "analysis/tubes/local_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mesh/vector.h"

namespace girth::tubes {
namespace {

constexpr std::size_t kMostTerms = 4;

/// The normal equations of a polynomial, and their right sides in three dimensions.
struct Equations {
  std::array<std::array<double, kMostTerms>, kMostTerms> left{};
  std::array<Vec3, kMostTerms> right{};

  /// The polynomial's coefficients, from the constant one on; by elimination with pivots.
  std::array<Vec3, kMostTerms> solve(std::size_t terms) {
    for (std::size_t k = 0; k < terms; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < terms; ++i) {
        if (std::fabs(left[i][k]) > std::fabs(left[pivot][k])) pivot = i;
      }
      std::swap(left[k], left[pivot]);
      std::swap(right[k], right[pivot]);
      for (std::size_t i = k + 1; i < terms; ++i) {
        const double share = left[i][k] / left[k][k];
        for (std::size_t j = k; j < terms; ++j) left[i][j] -= share * left[k][j];
        right[i] = right[i] - share * right[k];
      }
    }
    std::array<Vec3, kMostTerms> found{};
    for (std::size_t k = terms; k-- > 0;) {
      Vec3 sum = right[k];
      for (std::size_t j = k + 1; j < terms; ++j) sum = sum - left[k][j] * found[j];
      found[k] = (1 / left[k][k]) * sum;
    }
    return found;
  }
};

}  // namespace

LocalFit fitAt(std::span<const Vec3> points, std::span<const double> steps, std::size_t place,
               std::size_t reach) {
  const std::size_t wanted = std::min(2 * reach + 1, points.size());
  const std::size_t first =
      std::min(place > wanted / 2 ? place - wanted / 2 : 0, points.size() - wanted);
  const std::size_t terms = std::clamp<std::size_t>((wanted + 1) / 2, 2, kMostTerms);
  // Steps between −1 and 1 keep the equations well conditioned.
  double unit = 0;
  for (std::size_t i = first; i < first + wanted; ++i) {
    unit = std::max(unit, std::fabs(steps[i] - steps[place]));
  }
  Equations equations;
  for (std::size_t i = first; i < first + wanted; ++i) {
    const double t = (steps[i] - steps[place]) / unit;
    std::array<double, kMostTerms> powers{1, t, t * t, t * t * t};
    for (std::size_t k = 0; k < terms; ++k) {
      for (std::size_t j = 0; j < terms; ++j) equations.left[k][j] += powers[k] * powers[j];
      equations.right[k] = equations.right[k] + powers[k] * (points[i] - points[place]);
    }
  }
  const std::array<Vec3, kMostTerms> found = equations.solve(terms);
  return {(1 / unit) * found[1], (2 / (unit * unit)) * found[2],
          (6 / (unit * unit * unit)) * found[3]};
}

}  // namespace girth::tubes
