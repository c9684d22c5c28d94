#include "geodesic/fast_marching.h"

#include <algorithm>
#include <cmath>

#include "geodesic/vec2.h"
#include "mesh/neighbours.h"

namespace girth::geodesic {

namespace {

/// Faces laid out in search of a vertex inside an obtuse corner. On usable triangulations a few are
/// enough.
constexpr int kMostUnfolded = 64;

/// The third corner of a triangle over the segment from `a` to `b`, on its left, from the lengths
/// of the sides to it.
Vec2 cornerOver(Vec2 a, Vec2 b, double fromA, double fromB) {
  const Vec2 d = b - a;
  const double length = norm(d);
  const double along = (fromA * fromA - fromB * fromB + length * length) / (2 * length);
  const double height = std::sqrt(std::max(0.0, fromA * fromA - along * along));
  return a + (1 / length) * (along * d + height * Vec2{-d.y, d.x});
}

/// Distance over a triangle whose corners a and b are `distanceA` ≤ `distanceB` away: of a front
/// that crosses it straight, or else along a side (Kimmel and Sethian, section 4.1).
double acrossTriangle(double distanceA, double distanceB, double lengthA, double lengthB,
                      double cosine) {
  const double along = std::min(distanceA + lengthA, distanceB + lengthB);
  const double u = distanceB - distanceA;
  // With t the distance from a's front to the vertex: a quadratic p t² + 2 q t + r = 0.
  const double p = lengthA * lengthA + lengthB * lengthB - 2 * lengthA * lengthB * cosine;
  const double q = lengthA * u * (lengthB * cosine - lengthA);
  const double r = lengthA * lengthA * (u * u - lengthB * lengthB * (1 - cosine * cosine));
  const double discriminant = q * q - p * r;
  if (!(discriminant >= 0) || !(p > 0)) return along;
  const double t = (-q + std::sqrt(discriminant)) / p;
  if (!(u < t)) return along;
  // The front must come from inside the triangle.
  const double share = lengthA * (t - u) / t;
  if (!(lengthB * cosine < share) || !(share * cosine < lengthB)) return along;
  return std::min(along, distanceA + t);
}

}  // namespace

MarchingStencils::MarchingStencils(const SurfaceMesh& mesh) : mesh_(&mesh) {
  stencils_.reserve(mesh.halfedgeCount());
  for (const Halfedge h : mesh.halfedges()) addCorner(h);
  usersBegin_.assign(mesh.vertexCount() + 1, 0);
  for (const Stencil& s : stencils_) {
    ++usersBegin_[s.a + 1];
    ++usersBegin_[s.b + 1];
  }
  for (const Vertex v : mesh.vertices()) usersBegin_[v + 1] += usersBegin_[v];
  users_.resize(2 * stencils_.size());
  std::vector<Index> next(usersBegin_.begin(), usersBegin_.end() - 1);
  for (Index i = 0; i < stencils_.size(); ++i) {
    users_[next[stencils_[i].a]++] = i;
    users_[next[stencils_[i].b]++] = i;
  }
}

void MarchingStencils::addCorner(Halfedge h) {
  const SurfaceMesh& mesh = *mesh_;
  const Halfedge after = SurfaceMesh::next(h), before = SurfaceMesh::previous(h);
  const Vertex vertex = mesh.from(h), a = mesh.to(h), b = mesh.from(before);
  const double lengthA = mesh.length(h), lengthB = mesh.length(before);
  const Vec2 placeA{lengthA, 0};
  const Vec2 placeB = cornerOver({0, 0}, placeA, lengthB, mesh.length(after));
  const auto add = [&](Index first, Vec2 toFirst, Index second, Vec2 toSecond) {
    const double one = norm(toFirst), two = norm(toSecond);
    stencils_.push_back({first, second, one, two, dot(toFirst, toSecond) / (one * two)});
    vertexOf_.push_back(vertex);
  };
  if (placeB.x < 0) {
    // Obtuse. A vertex that makes acute angles with both sides splits the corner; it is looked for
    // along the middle of the directions that do.
    const auto splits = [&](Vec2 p) { return p.x >= 0 && dot(p, placeB) >= 0; };
    const Vec2 middle = (1 / lengthB) * Vec2{placeB.y, -placeB.x} + Vec2{0, 1};
    Vec2 left = placeB, right = placeA;  // the ends of `side`, which runs from left to right
    Halfedge side = mesh.twin(after);
    for (int step = 0; step < kMostUnfolded && side != Halfedge::none; ++step) {
      const Halfedge ofRight = SurfaceMesh::next(side), ofLeft = SurfaceMesh::previous(side);
      const Vertex beyond = mesh.from(ofLeft);
      const Vec2 place = cornerOver(left, right, mesh.length(ofLeft), mesh.length(ofRight));
      if (beyond != vertex && splits(place)) {
        add(a, placeA, beyond, place);
        add(beyond, place, b, placeB);
        return;
      }
      const bool passesRight = cross(middle, place) > 0;
      (passesRight ? left : right) = place;
      side = mesh.twin(passesRight ? ofRight : ofLeft);
    }
  }
  add(a, placeA, b, placeB);
}

void FastMarching::start(Index source) {
  for (const Index v : touched_) {
    distance_[v] = kFar;
    accepted_[v] = false;
  }
  touched_.clear();
  queue_ = {};
  offer(source, 0);
}

void FastMarching::offer(Index vertex, double distance) {
  if (!(distance < distance_[vertex])) return;
  if (distance_[vertex] == kFar) touched_.push_back(vertex);
  distance_[vertex] = distance;
  queue_.push({distance, vertex});
}

void FastMarching::spread(Index vertex) {
  const double here = distance_[vertex];
  forEachEdge(stencils_->mesh(), Vertex(vertex), [&](Halfedge edge, Vertex neighbour) {
    if (!accepted_[neighbour]) offer(neighbour, here + stencils_->mesh().length(edge));
  });
  for (const Index number : stencils_->usersOf(vertex)) {
    const Index target = stencils_->vertexOf(number);
    if (accepted_[target]) continue;
    const MarchingStencils::Stencil& s = stencils_->stencil(number);
    if (!accepted_[s.a] || !accepted_[s.b]) continue;
    const double atA = distance_[s.a], atB = distance_[s.b];
    offer(target, atA <= atB ? acrossTriangle(atA, atB, s.lengthA, s.lengthB, s.cosine)
                             : acrossTriangle(atB, atA, s.lengthB, s.lengthA, s.cosine));
  }
}

}  // namespace girth::geodesic
