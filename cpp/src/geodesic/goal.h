// A point that a propagation heads for: paths that cannot end there within a length are left out.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "geodesic/unfolding.h"
#include "mesh/vector.h"

namespace girth::geodesic {

/// A bound on lengths, which tells the windows that cannot reach a point in time. All lengths are
/// in `unfolding.unit()`.
class Goal {
 public:
  /// The straight way through space is no longer than any way over the surface. `limit`: the
  /// length of the longest paths that count.
  Goal(const Unfolding& unfolding, const Vec3& place, double limit)
      : Goal(unfolding, place, {}, limit) {}
  /// With better bounds: from each vertex no way to the point is shorter than `least`.
  Goal(const Unfolding& unfolding, std::vector<double> least, double limit)
      : Goal(unfolding, {}, std::move(least), limit) {}

  /// Whether a path that is so long at the nearest point of an edge may reach it.
  bool isInReach(Index halfedge, double length) const {
    const Crossing c = unfolding_->crossing(halfedge);
    return isInTime(length + (leastFrom(c.from()) + leastFrom(c.to()) - c.length()) / 2);
  }
  /// Whether a path that is so long at a vertex may, within two edges more: what is known of
  /// vertices a little aside keeps paths apart from shorter ones.
  bool isInReachOf(Index vertex, double length) const {
    return isInTime(length + leastFrom(vertex) - aside_);
  }
  /// No way from a vertex to the point is shorter.
  double leastFrom(Index vertex) const {
    if (!least_.empty()) return least_[vertex];
    const Vec3& at = unfolding_->mesh().position(Vertex(unfolding_->vertexInMesh(vertex)));
    return perUnit_ * norm(place_ - at);
  }
  /// The greatest length that a path to a vertex may have.
  double mostTo(Index vertex) const { return std::max(0.0, limit_ - leastFrom(vertex)); }

 private:
  /// For rounding.
  static constexpr double kSlack = 1e-9;

  Goal(const Unfolding& unfolding, const Vec3& place, std::vector<double> least, double limit)
      : unfolding_(&unfolding),
        place_(place),
        least_(std::move(least)),
        limit_(limit * (1 + kSlack)),
        perUnit_(1 / unfolding.unit()),
        aside_(2 * unfolding.mesh().meanEdgeLength() * perUnit_) {}

  bool isInTime(double length) const { return length <= limit_; }

  const Unfolding* unfolding_;
  Vec3 place_;
  std::vector<double> least_;
  double limit_, perUnit_, aside_;
};

}  // namespace girth::geodesic
