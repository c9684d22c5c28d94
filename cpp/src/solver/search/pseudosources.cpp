#include "solver/search/pseudosources.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace girth {

using geodesic::cross;
using geodesic::Crossing;
using geodesic::dot;
using geodesic::kTouch;
using geodesic::norm;
using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::Vec2;

void findPseudosources(const Propagation& propagation, Index face, double longest,
                       std::vector<Pseudosource>& sources) {
  const Unfolding& unfolding = propagation.unfolding();
  sources.clear();
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Crossing c = unfolding.crossing(h);
    const auto place = [&](Vec2 p) { return unfolding.toFrame(h, 3 * face, p); };
    if (propagation.settled(c.from())) {
      sources.push_back(
          {place({0, 0}), propagation.distance(c.from()), {0, 0}, {0, 0}, h - 3 * face});
    }
    propagation.eachEntered(h, [&](const geodesic::Window& w) {
      if (w.isSurelyLonger(c.length(), longest)) return;
      const Vec2 root = place(w.root);
      const Vec2 left = place({w.gapFrom, 0}) - root;
      const Vec2 right = place({c.length() - w.gapTo, 0}) - root;
      sources.push_back({root, w.sigma, (1 / norm(left)) * left, (1 / norm(right)) * right});
    });
  }
  for (const Propagation::Origin& origin : propagation.origins()) {
    if (origin.face == face) sources.push_back({origin.place, 0});
  }
}

bool differentRoots(const std::vector<Pseudosource>& sources, double slack, std::size_t most,
                    std::vector<Pseudosource>& roots) {
  for (const Pseudosource& source : sources) {
    const auto known = std::find_if(roots.begin(), roots.end(), [&](const Pseudosource& s) {
      return std::fabs(s.sigma - source.sigma) <= slack && norm(s.root - source.root) <= slack;
    });
    if (known != roots.end()) continue;
    if (roots.size() == most) return false;
    roots.push_back(source);
  }
  return true;
}

std::array<Vec2, 3> cornersOf(const Unfolding& unfolding, Index face) {
  std::array<Vec2, 3> corners;
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    corners[h - 3 * face] = unfolding.toFrame(h, 3 * face, {0, 0});
  }
  return corners;
}

namespace {

/// A point at one distance from three sources, more exactly: where two of them lie almost behind
/// each other, the squares of the distances give it to half the digits only.
Vec2 refined(Vec2 q, const Pseudosource& a, const Pseudosource& b, const Pseudosource& c) {
  const auto missing = [&](Vec2 p) {
    return Vec2{a.distanceTo(p) - b.distanceTo(p), a.distanceTo(p) - c.distanceTo(p)};
  };
  const auto away = [&](const Pseudosource& source) {
    return (1 / norm(q - source.root)) * (q - source.root);
  };
  Vec2 off = missing(q);
  for (int step = 0; step < 3; ++step) {
    const Vec2 x = away(a) - away(b), y = away(a) - away(c);
    const Vec2 p =
        q - (1 / cross(x, y)) * Vec2{off.x * y.y - off.y * x.y, off.y * x.x - off.x * y.x};
    const Vec2 left = missing(p);
    if (!(norm(left) < norm(off))) break;
    q = p;
    off = left;
  }
  return q;
}

}  // namespace

int meetingPoints(const Pseudosource& a, const Pseudosource& b, const Pseudosource& c,
                  std::array<Vec2, 2>& points) {
  // With a at the origin and D' = D − σ_a:  |q| = D',  |q − r_i| = D' − s_i.  Subtracting the
  // squares leaves  2 r_i·q = |r_i|² − s_i² + 2 s_i D'  for i = b, c: linear in q = u + v D'.
  const Vec2 rb = b.root - a.root, rc = c.root - a.root;
  const double sb = b.sigma - a.sigma, sc = c.sigma - a.sigma;
  const double det = 2 * cross(rb, rc);
  if (det == 0) return 0;
  const double kb = dot(rb, rb) - sb * sb, kc = dot(rc, rc) - sc * sc;
  const Vec2 u = (1 / det) * Vec2{kb * rc.y - kc * rb.y, kc * rb.x - kb * rc.x};
  const Vec2 v = (2 / det) * Vec2{sb * rc.y - sc * rb.y, sc * rb.x - sb * rc.x};
  // |u + v D'| = D':  (v·v − 1) D'² + 2 u·v D' + u·u = 0.
  const double p = dot(v, v) - 1, q = dot(u, v), r = dot(u, u);
  const double discriminant = q * q - p * r;
  if (discriminant < 0) return 0;
  const double root = std::sqrt(discriminant);
  // The stable pair of solutions.
  const double t = q >= 0 ? -q - root : -q + root;
  int count = 0;
  for (const double distance : {r / t, t / p}) {
    if (!(std::isfinite(distance) && distance >= 0)) continue;
    points[count++] = refined(a.root + (u + distance * v), a, b, c);
  }
  return count;
}

std::optional<Vec2> withinFace(const Propagation& propagation, Index face, Vec2 q) {
  const Unfolding& unfolding = propagation.unfolding();
  Vec2 nearest = q;
  double way = std::numeric_limits<double>::infinity();
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const double length = unfolding.crossing(h).length();
    const Vec2 p = unfolding.toFrame(3 * face, h, q);
    if (!(p.y >= -kTouch * length)) return std::nullopt;
    if (p.y >= 0) continue;
    const Vec2 onSide{std::clamp(p.x, 0.0, length), 0};
    if (norm(p - onSide) >= way) continue;
    way = norm(p - onSide);
    nearest = unfolding.toFrame(h, 3 * face, onSide);
  }
  return nearest;
}

}  // namespace girth
