#include "girth/farthest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace girth {

using geodesic::cross;
using geodesic::Crossing;
using geodesic::dot;
using geodesic::kTie;
using geodesic::kTouch;
using geodesic::norm;
using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::Vec2;

namespace {

/// Where paths into a face come from, in the plane of the face: the root of a window, or a corner
/// that sends out paths of its own.
struct Site {
  Vec2 root;
  double sigma;
  Vec2 left{0, 0}, right{0, 0};  // unit vectors along the bounds of the window; zero: unbounded

  double distanceTo(Vec2 q) const { return sigma + norm(q - root); }
  /// Whether the window covers a point of this disk.
  bool meetsDisk(Vec2 centre, double radius) const {
    return cross(left, centre - root) <= radius && cross(right, centre - root) >= -radius;
  }
};

/// The points at which three sites are at one distance: |q − r_i| + σ_i = D for all three (the
/// problem of Apollonius); up to two of them.
int meetingPoints(const Site& a, const Site& b, const Site& c, std::array<Vec2, 2>& points) {
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
  const auto take = [&](double distance) {
    if (std::isfinite(distance) && distance >= 0) points[count++] = a.root + (u + distance * v);
  };
  if (t != 0) take(r / t);
  if (p != 0) take(t / p);
  return count;
}

/// The points of a line at which two sites are at one distance, as places along it.
/// `a`, `b`: the roots in a frame whose x axis is the line.
int meetingPlaces(Vec2 a, double sigmaA, Vec2 b, double sigmaB, std::array<double, 2>& places) {
  // With u = x − a.x, r = b.x − a.x, s = σ_b − σ_a:  √(u² + a.y²) = √((u − r)² + b.y²) + s.
  // Squared once:  2 r u + k = 2 s √(u² + a.y²)  with  k = s² + a.y² − b.y² − r²  (sign of s kept
  // by the test of the distance that follows); squared again: a quadratic in u.
  const double r = b.x - a.x, s = sigmaB - sigmaA;
  const double k = a.y * a.y - b.y * b.y - r * r + s * s;
  const double p = r * r - s * s, q = r * k / 2, c = k * k / 4 - s * s * a.y * a.y;
  // q² − p c, written so that equal sigmas, the usual case, leave exactly 0.
  const double quarter = k * k / 4 + p * a.y * a.y;
  if (quarter < 0) return 0;
  const double root = std::fabs(s) * std::sqrt(quarter);
  const double t = q >= 0 ? -q - root : -q + root;
  int count = 0;
  if (t != 0) places[count++] = a.x + c / t;
  if (p != 0) places[count++] = a.x + t / p;
  return count;
}

bool insideFace(const Propagation& propagation, Index face, Vec2 q) {
  const Unfolding& unfolding = propagation.unfolding();
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    if (!(unfolding.toFrame(3 * face, h, q).y >= -kTouch * unfolding.crossing(h).length())) {
      return false;
    }
  }
  return true;
}

/// Searches faces, most promising parts first.
class FaceSearch {
 public:
  FaceSearch(const Propagation& propagation, FarthestPoint& best)
      : propagation_(propagation), best_(best), atLeast_(best.distance) {}

  /// Everything in the frame of the face's first halfedge.
  void search(Index face) {
    face_ = face;
    const Unfolding& unfolding = propagation_.unfolding();
    std::vector<Site> sites;
    std::array<Vec2, 3> corners;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Crossing c = unfolding.crossing(h);
      const auto place = [&](Vec2 p) { return unfolding.toFrame(h, 3 * face, p); };
      corners[h - 3 * face] = place({0, 0});
      if (propagation_.settled(c.from())) {
        sites.push_back({place({0, 0}), propagation_.distance(c.from())});
      }
      for (std::uint32_t i = 0; i < propagation_.enteredCount(h); ++i) {
        const geodesic::Window w = propagation_.window(h, i);
        const Vec2 root = place(w.root);
        const Vec2 left = place({w.gapFrom, 0}) - root;
        const Vec2 right = place({c.length() - w.gapTo, 0}) - root;
        sites.push_back({root, w.sigma, (1 / norm(left)) * left, (1 / norm(right)) * right});
      }
    }
    for (const Propagation::Origin& origin : propagation_.origins()) {
      if (origin.face == face) sites.push_back({origin.place, 0});
    }
    std::priority_queue<Cell> cells;
    add(cells, corners, sites, 0);
    while (!cells.empty() && cells.top().bound > atLeast_) {
      const Cell cell = cells.top();
      cells.pop();
      if (cell.sites.size() <= kFewSites || cell.depth == kDeepest) {
        testTriples(cell.sites);
        continue;
      }
      const auto& [a, b, c] = cell.corners;
      const Vec2 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
      add(cells, {a, ab, ca}, cell.sites, cell.depth + 1);
      add(cells, {ab, b, bc}, cell.sites, cell.depth + 1);
      add(cells, {ca, bc, c}, cell.sites, cell.depth + 1);
      add(cells, {ab, bc, ca}, cell.sites, cell.depth + 1);
    }
  }

 private:
  static constexpr std::size_t kFewSites = 8;
  static constexpr int kDeepest = 16;

  /// A triangle of the face, with the sites that may be nearest to a point of it.
  struct Cell {
    double bound;  // the distance is nowhere greater
    std::array<Vec2, 3> corners;
    std::vector<Site> sites;
    int depth;
    bool operator<(const Cell& other) const { return bound < other.bound; }
  };

  void add(std::priority_queue<Cell>& cells, const std::array<Vec2, 3>& corners,
           const std::vector<Site>& sites, int depth) {
    const Vec2 centre = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
    double radius = 0;
    for (const Vec2 corner : corners) radius = std::max(radius, norm(corner - centre));
    // The distance changes by no more than the way walked.
    const double atCentre = distanceAmong(sites, centre);
    atLeast_ = std::max(atLeast_, atCentre);
    if (atCentre + radius <= atLeast_) return;
    Cell cell{atCentre + radius, corners, {}, depth};
    const double margin = radius * (1 + 1e-6) + kTie * best_.distance;
    for (const Site& site : sites) {
      if (site.distanceTo(centre) <= atCentre + 2 * margin && site.meetsDisk(centre, margin)) {
        cell.sites.push_back(site);
      }
    }
    cells.push(std::move(cell));
  }

  /// Distance of a point from the sites that see it.
  double distanceAmong(const std::vector<Site>& sites, Vec2 q) const {
    double distance = std::numeric_limits<double>::infinity();
    for (const Site& site : sites) {
      const Vec2 ray = q - site.root;
      const double squared = dot(ray, ray), rest = distance - site.sigma;
      if (rest > 0 && squared < rest * rest && site.meetsDisk(q, kTie * best_.distance)) {
        distance = site.sigma + std::sqrt(squared);
      }
    }
    return distance;
  }

  void testTriples(const std::vector<Site>& all) {
    // Windows of one root, which differ only in the way they pass flat vertices, are one site.
    std::vector<Site> sites;
    const double slack = kTie * best_.distance;
    for (const Site& site : all) {
      const auto known = std::find_if(sites.begin(), sites.end(), [&](const Site& s) {
        return std::fabs(s.sigma - site.sigma) <= slack && norm(s.root - site.root) <= slack;
      });
      if (known == sites.end()) sites.push_back(site);
    }
    for (std::size_t i = 0; i < sites.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          std::array<Vec2, 2> points;
          const int count = meetingPoints(sites[i], sites[j], sites[k], points);
          for (int n = 0; n < count; ++n) test(points[n], sites[i], all);
        }
        testBoundaries(sites[i], sites[j], all);
      }
    }
  }

  /// On a boundary two paths are enough.
  void testBoundaries(const Site& a, const Site& b, const std::vector<Site>& all) {
    const Unfolding& unfolding = propagation_.unfolding();
    for (Index h = 3 * face_; h < 3 * face_ + 3; ++h) {
      if (unfolding.twin(h) != kNoIndex) continue;
      std::array<double, 2> places;
      const int count = meetingPlaces(unfolding.toFrame(3 * face_, h, a.root), a.sigma,
                                      unfolding.toFrame(3 * face_, h, b.root), b.sigma, places);
      for (int n = 0; n < count; ++n) {
        if (std::isfinite(places[n])) test(unfolding.toFrame(h, 3 * face_, {places[n], 0}), a, all);
      }
    }
  }

  void test(Vec2 q, const Site& site, const std::vector<Site>& sites) {
    const double distance = site.distanceTo(q);
    // A point that ties with a vertex is that vertex, found again beside it.
    if (!(distance > best_.distance * (1 + kTie)) || !insideFace(propagation_, face_, q)) return;
    // The sites may be out of sight from there, or the point outside the part of the face where no
    // others count: what decides is the true distance; first, cheaply, a bound to it.
    if (std::fabs(distanceAmong(sites, q) - distance) > kTie * distance) return;
    geodesic::WindowNumber nearer;
    if (propagation_.findNearer(3 * face_, q, distance * (1 - kTie), nearer)) return;
    best_ = {distance, 3 * face_, q};
    atLeast_ = std::max(atLeast_, distance * (1 - kTie));
  }

  const Propagation& propagation_;
  FarthestPoint& best_;
  double atLeast_;  // the maximum is known to be no less
  Index face_{0};
};

}  // namespace

FarthestPoint farthestPoint(const Propagation& propagation) {
  const Unfolding& unfolding = propagation.unfolding();
  FarthestPoint best;
  for (const Index v : propagation.reachedVertices()) {
    if (propagation.distance(v) > best.distance) {
      best = {propagation.distance(v), unfolding.outgoing(v), {0, 0}};
    }
  }

  // Faces that could hold a farther point, judged by their corners; each once, at its first corner.
  FaceSearch faces(propagation, best);
  for (const Index v : propagation.reachedVertices()) {
    const Index start = unfolding.outgoing(v);
    for (Index out = start; out != kNoIndex;) {
      const Index face = faceOfSide(out);
      if (out == 3 * face && propagation.farthestWithin(face) > best.distance) faces.search(face);
      out = unfolding.turnLeft(out);
      if (out == start) break;
    }
  }
  return best;
}

}  // namespace girth
