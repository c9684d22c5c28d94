// A point that a propagation heads for: paths that cannot end there within a length are left out.
#pragma once

#include <cmath>

#include "geodesic/unfolding.h"
#include "mesh/vector.h"

namespace girth::geodesic {

/// What cannot reach a point in time. The straight way through space is no longer than any way over
/// the surface.
class Goal {
 public:
  /// `limit`: the length of the longest paths that count, in `unfolding.unit()`.
  Goal(const Unfolding& unfolding, const Vec3& place, double limit)
      : unfolding_(&unfolding),
        place_(place),
        limit_(limit * (1 + kSlack)),
        perUnit_(1 / unfolding.unit()) {}

  /// Whether a path that is so long at the nearest point of an edge may reach it.
  bool isInReach(Index halfedge, double length) const {
    const Crossing c = unfolding_->crossing(halfedge);
    const Vec3 from = position(c.from()), to = position(c.to());
    const Vec3 middle = 0.5 * (from + to);
    return isInReach(middle, length - c.length() / 2);
  }
  /// And one that is so long at a vertex.
  bool isInReachOf(Index vertex, double length) const {
    return isInReach(position(vertex), length);
  }

 private:
  /// For rounding.
  static constexpr double kSlack = 1e-9;

  Vec3 position(Index vertex) const {
    return unfolding_->mesh().position(Vertex(unfolding_->vertexInMesh(vertex)));
  }
  bool isInReach(const Vec3& at, double length) const {
    const double rest = limit_ - length;
    const Vec3 way = perUnit_ * (place_ - at);
    return rest >= 0 && dot(way, way) <= rest * rest;
  }

  const Unfolding* unfolding_;
  Vec3 place_;
  double limit_, perUnit_;
};

}  // namespace girth::geodesic
