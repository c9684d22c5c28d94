#include "solver/search/arrivals.h"

#include <algorithm>
#include <cmath>

namespace girth {

using geodesic::Crossing;
using geodesic::norm;
using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::Vec2;
using geodesic::Window;

namespace {

/// In all faces of a vertex, and along its edges.
void findArrivalsAtVertex(const Propagation& propagation, Index vertex, double reach,
                          Arrivals& arrivals) {
  const Unfolding& unfolding = propagation.unfolding();
  arrivals.total = unfolding.totalAngle(vertex);
  arrivals.open = unfolding.boundary(vertex);
  arrivals.vertex = vertex;
  const Index start = unfolding.outgoing(vertex);
  for (Index out = start;;) {
    const Crossing side = unfolding.crossing(out);
    const auto alongEdge = [&](Index neighbour, double length, double direction, double leaving) {
      const double whole = propagation.distance(neighbour) + length;
      if (whole <= reach && propagation.passesStraight(neighbour, leaving)) {
        arrivals.paths.push_back({direction, whole, {{}, neighbour}});
      }
    };
    alongEdge(side.to(), side.length(), unfolding.direction(out), unfolding.directionBack(out));
    const Index opposite = Unfolding::next(out);
    const Crossing entry = unfolding.crossing(opposite);
    propagation.eachEntered(opposite, [&](const Window& w) {
      if (w.distanceTo(entry.apex()) > reach || !w.covers(entry.length(), entry.apex())) return;
      const double whole = w.pathTo(entry.length(), entry.apex());
      if (whole <= reach) {
        arrivals.paths.push_back(
            {unfolding.directionOf(out, unfolding.toPrevious(opposite, w.root)),
             whole,
             {{opposite, w.root, w.sigma}, kNoIndex}});
      }
    });
    const Index left = unfolding.turnLeft(out);
    if (left == kNoIndex) {
      alongEdge(side.apexVertex(), side.leftLength(), arrivals.total,
                unfolding.direction(Unfolding::previous(out)));
    }
    if (left == kNoIndex || left == start) break;
    out = left;
  }
}

}  // namespace

bool Arrivals::surround(double gap) {
  if (paths.empty()) return false;
  std::sort(paths.begin(), paths.end(),
            [](const PathArrival& a, const PathArrival& b) { return a.direction < b.direction; });
  for (std::size_t i = 0; i + 1 < paths.size(); ++i) {
    if (paths[i + 1].direction - paths[i].direction >= gap) return false;
  }
  if (open) return paths.front().direction < gap && total - paths.back().direction < gap;
  return paths.front().direction + total - paths.back().direction < gap;
}

double Arrivals::directionTo(const Unfolding& unfolding, Index halfedge, Vec2 point,
                             Vec2 other) const {
  const Vec2 d =
      unfolding.toFrame(halfedge, base, other) - unfolding.toFrame(halfedge, base, point);
  return open ? signedAngleOf(d.x, d.y) : fullAngleOf(d.x, d.y);
}

void findArrivals(const Propagation& propagation, Index halfedge, Vec2 point, double reach,
                  Arrivals& arrivals) {
  const Unfolding& unfolding = propagation.unfolding();
  const Index face = faceOfSide(halfedge);
  arrivals.paths.clear();
  arrivals.vertex = arrivals.base = kNoIndex;

  for (Index corner = 3 * face; corner < 3 * face + 3; ++corner) {
    const Crossing c = unfolding.crossing(corner);
    const Vec2 q = unfolding.toFrame(halfedge, corner, point);
    if (norm(q) > kTogether * c.length()) continue;
    return findArrivalsAtVertex(propagation, c.from(), reach + norm(q), arrivals);
  }

  // Inside the face or on a side of it: as seen from that side.
  Index base = halfedge;
  bool onSide = false;
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Vec2 q = unfolding.toFrame(halfedge, h, point);
    if (q.y <= kTogether * unfolding.crossing(h).length()) {
      base = h;
      onSide = true;
    }
  }
  arrivals.open = onSide && unfolding.twin(base) == kNoIndex;
  arrivals.total = arrivals.open ? kPi : 2 * kPi;
  arrivals.base = base;
  const Vec2 q = unfolding.toFrame(halfedge, base, point);
  const auto arrive = [&](Vec2 from, double length, const PathHalf& half) {
    arrivals.paths.push_back({arrivals.directionTo(unfolding, base, q, from), length, half});
  };
  for (const Index h : {base, Unfolding::next(base), Unfolding::previous(base)}) {
    const Crossing c = unfolding.crossing(h);
    const Vec2 there = unfolding.toFrame(base, h, q);
    const double over = propagation.distance(c.from()) + norm(there);
    if (over <= reach && propagation.passesStraight(c.from(), unfolding.directionOf(h, there))) {
      arrive(unfolding.toFrame(h, base, {0, 0}), over, {{}, c.from()});
    }
    propagation.eachEntered(h, [&](const Window& w) {
      if (w.distanceTo(there) > reach || !w.covers(c.length(), there)) return;
      const double whole = w.pathTo(c.length(), there);
      if (whole <= reach) {
        const Vec2 from = w.comesFrom(c.length(), there);
        arrive(unfolding.toFrame(h, base, from), whole, {{h, w.root, w.sigma}, kNoIndex});
      }
    });
  }
  for (const Propagation::Origin& origin : propagation.origins()) {
    if (origin.face != face) continue;
    const Vec2 place = unfolding.toFrame(3 * face, base, origin.place);
    if (norm(place - q) <= reach) arrive(place, norm(place - q), {});
  }
}

}  // namespace girth
