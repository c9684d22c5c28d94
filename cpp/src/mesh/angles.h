// Angles from + − × ÷ √ alone. The functions of the C library differ in their last bits from system
// to system; these give the same bits natively and in WebAssembly, which is what lets both agree on
// every value. Accurate to a few units in the last place.
#pragma once

#include <cmath>

namespace girth {

inline constexpr double kPi = 3.141592653589793238462643383279502884;

/// The angle of the vector (x, y) against the x axis, in [0, π], for y ≥ 0 and not both zero.
inline double angleOf(double x, double y) {
  // Reduce to t = tan of at most π/16: first into the first octant, then by halving the angle
  // twice.
  const double ax = std::fabs(x);
  const bool steep = y > ax;
  double t = steep ? ax / y : y / ax;
  t = t / (1 + std::sqrt(1 + t * t));
  t = t / (1 + std::sqrt(1 + t * t));
  const double t2 = t * t;
  double sum = 0;
  for (int k = 23; k >= 3; k -= 2) sum = t2 * (((k / 2) % 2 == 0 ? 1.0 : -1.0) / k + sum);
  double angle = 4 * (t + t * sum);
  if (steep) angle = kPi / 2 - angle;
  return x < 0 ? kPi - angle : angle;
}

/// The angle of any vector but (0, 0) against the x axis, counter-clockwise, in [0, 2π).
inline double fullAngleOf(double x, double y) {
  const double angle = angleOf(x, std::fabs(y));
  return y < 0 ? 2 * kPi - angle : angle;
}

/// The angle of any vector but (0, 0) in [−π/2, 3π/2): just below the axis it
/// is just below 0, or just above π.
inline double signedAngleOf(double x, double y) {
  return y < 0 && x > 0 ? -angleOf(x, -y) : fullAngleOf(x, y);
}

struct CosSin {
  double cos, sin;
};

/// Cosine and sine of an angle in [0, π].
inline CosSin cosSin(double angle) {
  // A quarter of the angle lies below π/4, where the series converge fast; doubling it twice brings
  // the angle back.
  const double x = angle / 4, x2 = x * x;
  double c = 0, s = 0;
  for (int k = 20; k >= 2; k -= 2) {
    c = -x2 / (k * (k - 1)) * (1 + c);
    s = -x2 / (k * (k + 1)) * (1 + s);
  }
  double cosine = 1 + c, sine = x * (1 + s);
  for (int doubling = 0; doubling < 2; ++doubling) {
    const double doubled = 2 * sine * cosine;
    cosine = (cosine - sine) * (cosine + sine);
    sine = doubled;
  }
  return {cosine, sine};
}

}  // namespace girth
