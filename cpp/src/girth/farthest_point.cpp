#include "girth/farthest_point.h"

#include <array>
#include <cmath>
#include <optional>

namespace girth {

using geodesic::cross;
using geodesic::dot;
using geodesic::kTie;
using geodesic::kTouch;
using geodesic::norm;
using geodesic::Propagation;
using geodesic::Side;
using geodesic::Vec2;

namespace {

/// A source of paths in the plane of one face.
struct Site {
  Vec2 root;
  double sigma;
  Index window;
};

/// The points at which three sites are at one distance: |q − r_i| + σ_i = D for all three (the problem of
/// Apollonius); up to two of them.
int meetingPoints(const Site& a, const Site& b, const Site& c, std::array<Vec2, 2>& points) {
  // With a at the origin and D' = D − σ_a:  |q| = D',  |q − r_i| = D' − s_i.  Subtracting the squares
  // leaves  2 r_i·q = |r_i|² − s_i² + 2 s_i D'  for i = b, c: linear in q = u + v D'.
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
  const auto take = [&](double distance) {
    if (std::isfinite(distance) && distance >= 0) points[count++] = a.root + (u + distance * v);
  };
  if (t != 0) take(r / t);
  if (p != 0) take(t / p);
  return count;
}

bool insideFace(const Propagation& propagation, Index face, Vec2 q) {
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Side& side = propagation.unfolding().side(h);
    if (!(cross(side.direction, q - side.start) >= -kTouch * side.length)) return false;
  }
  return true;
}

}  // namespace

FarthestPoint farthestPoint(const Propagation& propagation) {
  const SurfaceMesh& mesh = propagation.unfolding().mesh();
  FarthestPoint best;
  for (const Index v : propagation.reachedVertices()) {
    const double distance = propagation.arrival(v).distance;
    if (best.vertex != kNoIndex && distance <= best.distance) continue;
    const Index h = mesh.outgoing(v);
    best = {distance, SurfaceMesh::faceOf(h), propagation.unfolding().side(h).start, kNoIndex, v};
  }

  std::vector<Site> sites;
  for (const Index v : propagation.reachedVertices()) {
    Index out = mesh.outgoing(v);
    do {
      const Index face = SurfaceMesh::faceOf(out);
      // Each face once: at its first corner.
      double bound = out == 3 * face ? std::numeric_limits<double>::infinity() : 0;
      for (Index h = 3 * face; h < 3 * face + 3 && bound > best.distance; ++h) {
        const double longest = std::max(mesh.length(h), mesh.length(SurfaceMesh::previous(h))) /
                               propagation.unfolding().unit();
        bound = std::min(bound, propagation.arrival(mesh.from(h)).distance + longest);
      }
      if (bound > best.distance) {
        sites.clear();
        for (Index h = 3 * face; h < 3 * face + 3; ++h) {
          for (Index w = propagation.firstWindow(h); w != kNoIndex;
               w = propagation.window(w).sibling) {
            sites.push_back({propagation.window(w).root, propagation.window(w).sigma, w});
          }
        }
        for (std::size_t i = 0; i < sites.size(); ++i) {
          for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) {
              std::array<Vec2, 2> points;
              const int count = meetingPoints(sites[i], sites[j], sites[k], points);
              for (int n = 0; n < count; ++n) {
                const Vec2 q = points[n];
                const double distance = sites[i].sigma + norm(q - sites[i].root);
                if (!(distance > best.distance) || !insideFace(propagation, face, q)) continue;
                if (propagation.distanceAt(face, q) < distance * (1 - kTie)) continue;
                const geodesic::Window& w = propagation.window(sites[i].window);
                if (!w.covers(propagation.unfolding().side(w.halfedge), q)) continue;
                best = {distance, face, q, sites[i].window, kNoIndex};
              }
            }
          }
        }
      }
      out = mesh.twin(SurfaceMesh::previous(out));
    } while (out != mesh.outgoing(v));
  }
  return best;
}

}  // namespace girth
