#include "mesh/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "mesh/vector.h"

namespace girth {
namespace {

/// The error of the determinant as it is rounded, as a share of the sum of its products' sizes
/// (Shewchuk).
constexpr double kRounding = (7 + 56 * std::numeric_limits<double>::epsilon()) *
                             (std::numeric_limits<double>::epsilon() / 2);

/// A sum of doubles that do not overlap, the smallest first, zeros among them.
class Expansion {
 public:
  void add(double value) {
    for (double& part : parts_) {
      const double sum = part + value;
      const double shift = sum - part;
      part = (part - (sum - shift)) + (value - shift);
      value = sum;
    }
    parts_.push_back(value);
  }
  /// By halves of 26 bits (Dekker), as std::fma rounds twice in some libraries (MinGW-w64).
  void addProduct(double a, double b) {
    const double product = a * b;
    const auto [aHigh, aLow] = halves(a);
    const auto [bHigh, bLow] = halves(b);
    add(aLow * bLow - (product - aHigh * bHigh - aLow * bHigh - aHigh * bLow));
    add(product);
  }
  /// Their sign is that of the greatest.
  int sign() const {
    for (std::size_t i = parts_.size(); i-- > 0;) {
      if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
    }
    return 0;
  }
  const std::vector<double>& parts() const { return parts_; }

 private:
  /// The upper and the lower bits of a number, without rounding (Veltkamp).
  static std::array<double, 2> halves(double value) {
    constexpr double kSplitter = (1 << 27) + 1;
    const double scaled = kSplitter * value;
    const double high = scaled - (scaled - value);
    return {high, value - high};
  }

  std::vector<double> parts_;
};

/// A difference without rounding: what is rounded, and what that left out.
std::array<double, 2> difference(double a, double b) {
  const double rounded = a - b;
  const double shift = a - rounded;
  return {rounded, (a - (rounded + shift)) + (shift - b)};
}

using Exact3 = std::array<std::array<double, 2>, 3>;

Exact3 exactly(const Vec3& a, const Vec3& d) {
  return {difference(a.x, d.x), difference(a.y, d.y), difference(a.z, d.z)};
}

/// Adds or subtracts the product of three differences.
void addProducts(Expansion& sum, double sign, const std::array<double, 2>& a,
                 const std::array<double, 2>& b, const std::array<double, 2>& c) {
  Expansion pair;
  for (const double p : a) {
    for (const double q : b) pair.addProduct(sign * p, q);
  }
  for (const double p : pair.parts()) {
    for (const double q : c) sum.addProduct(p, q);
  }
}

int exactSign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Exact3 u = exactly(a, d), v = exactly(b, d), w = exactly(c, d);
  Expansion sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    addProducts(sum, 1, u[i], v[j], w[k]);
    addProducts(sum, -1, u[i], v[k], w[j]);
  }
  return sum.sign();
}

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double determinant = dot(u, cross(v, w));
  const double size = std::fabs(u.x) * (std::fabs(v.y * w.z) + std::fabs(v.z * w.y)) +
                      std::fabs(u.y) * (std::fabs(v.z * w.x) + std::fabs(v.x * w.z)) +
                      std::fabs(u.z) * (std::fabs(v.x * w.y) + std::fabs(v.y * w.x));
  if (determinant > kRounding * size) return 1;
  if (determinant < -kRounding * size) return -1;
  return exactSign(a, b, c, d);
}

}  // namespace girth
