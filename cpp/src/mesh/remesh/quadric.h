// The sum of squared distances to many planes (Garland and Heckbert 1997).
#pragma once

#include <array>
#include <optional>

#include "mesh/vector.h"

namespace girth::remeshing {

/// x ↦ xᵀA x + 2 bᵀx + c.
class Quadric {
 public:
  Quadric() = default;

  /// The squared distance to the plane through a point across a unit normal, times a weight.
  static Quadric ofPlane(const Vec3& point, const Vec3& normal, double weight);
  /// The squared distance to a point, times a weight.
  static Quadric ofPoint(const Vec3& point, double weight);

  Quadric& operator+=(const Quadric& other);

  double at(const Vec3& x) const;
  /// Where the sum is least; nothing where that is not one place (no points, or of no weight).
  std::optional<Vec3> least() const;

 private:
  std::array<double, 6> a_{};  ///< xx, xy, xz, yy, yz, zz
  Vec3 b_;
  double c_{0};
};

}  // namespace girth::remeshing
