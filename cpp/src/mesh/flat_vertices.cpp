#include "mesh/flat_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "mesh/nearest_point.h"
#include "mesh/remesh/changing_mesh.h"
#include "mesh/remesh/face_checks.h"
#include "mesh/remesh/lookout.h"
#include "mesh/remesh/result.h"
#include "mesh/vertex_normals.h"

namespace girth {

namespace {

using remeshing::ChangingMesh;
using remeshing::Lookout;

/// The shape of a face is 1 where its sides are equal, and 0 where it has no area. It may become
/// worse down to this.
constexpr double kPoorShape = 0.05;
/// Surfaces with larger coordinates, or only smaller ones than the inverse, stay as they are:
/// fourth powers of lengths must neither overflow nor vanish.
constexpr double kLargest = 1e60;

double shapeOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  const double squares = dot(ab, ab) + dot(bc, bc) + dot(ca, ca);
  return squares > 0 ? 2 * std::sqrt(3.0) * norm(cross(ab, bc)) / squares : 0;
}

class FlatVertices {
 public:
  FlatVertices(const SurfaceMesh& original, double turn, const ExecutionContext& context)
      : original_(original),
        turn_(turn),
        lookout_(context),
        mesh_(original),
        planes_(normalsOfFaces(original)),
        first_(original.faceCount(), kNoIndex),
        next_(original.vertexCount(), kNoIndex),
        places_(original.vertexCount()) {}

  Result<LeanSurface> run() {
    std::deque<Index> queue;
    std::vector<bool> isQueued(original_.vertexCount(), true);
    if (isOfOrdinarySize()) {
      for (const Vertex v : original_.vertices()) queue.push_back(v);
    }
    while (!queue.empty()) {
      if (lookout_.stopped()) return Lookout::error();
      const Index vertex = queue.front();
      queue.pop_front();
      isQueued[vertex] = false;
      const std::optional<Index> way = bestWay(vertex);
      if (!way) continue;
      const Index left = remove(*way);
      const auto again = [&](Index v) {
        if (!isQueued[v]) queue.push_back(v);
        isQueued[v] = true;
      };
      again(left);
      mesh_.forEachNeighbour(left, [&](Index v, bool) { again(v); });
    }
    return collect();
  }

 private:
  bool isOfOrdinarySize() const {
    double extent = 0;
    for (const Vertex v : original_.vertices()) {
      const Vec3& p = original_.position(v);
      extent = std::max({extent, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
    return extent <= kLargest && extent >= 1 / kLargest;
  }

  /// The edge along which a vertex can go, so that the worst face that is left has the best shape.
  std::optional<Index> bestWay(Index vertex) const {
    std::optional<Index> best;
    double bestShape = 0;
    mesh_.forEachOutgoing(vertex, [&](Index h) {
      const double shape = shapeAfter(h);
      if (shape > bestShape && keepsLines(h) && mesh_.canCollapse(h)) {
        best = h;
        bestShape = shape;
      }
    });
    return best;
  }

  /// Whether a vector has the direction of a unit vector.
  bool isAlong(const Vec3& vector, const Vec3& direction) const {
    return dot(vector, direction) > 0 && norm(cross(vector, direction)) <= turn_ * norm(vector);
  }
  /// Whether there are faces on both sides of an edge, and both lie in one plane.
  bool isFlatAcross(Index h) const {
    const Index twin = mesh_.twin(h);
    return twin != kNoIndex && isAlong(planes_[h / 3], planes_[twin / 3]);
  }

  /// The worst shape of a face after the start of an edge has gone to its end; 0: it may not.
  double shapeAfter(Index h) const {
    const Index vertex = mesh_.from(h), to = mesh_.to(h);
    const Vec3& place = mesh_.position(to);
    double before = 1, after = 1;
    mesh_.forEachOutgoing(vertex, [&](Index out) {
      if (after == 0) return;
      const Index b = mesh_.to(out), c = mesh_.apex(out);
      const Vec3 &pb = mesh_.position(b), &pc = mesh_.position(c);
      before = std::min(before, shapeOf(mesh_.position(vertex), pb, pc));
      if (b == to || c == to) return;
      const Vec3 area = cross(pb - place, pc - place);
      const Vec3& plane = planes_[out / 3];
      after = isAlong(area, plane) && remeshing::hasArea(place, pb, pc)
                  ? std::min(after, shapeOf(place, pb, pc))
                  : 0;
    });
    return after < std::min(before, kPoorShape) ? 0 : after;
  }

  /// Whether the creases and boundaries at the start of an edge stay where they are when it goes to
  /// the end: there are none, or one that runs straight through it and along the edge.
  bool keepsLines(Index h) const {
    const Index to = mesh_.to(h);
    const Vec3& place = mesh_.position(mesh_.from(h));
    bool isAny = false, isOnLine = false, isStraight = true;
    const auto look = [&](Index neighbour, bool isLine) {
      if (!isLine) return;
      isAny = true;
      if (neighbour == to) {
        isOnLine = true;
        return;
      }
      const Vec3 one = mesh_.position(to) - place, other = place - mesh_.position(neighbour);
      isStraight = isStraight && isAlong(one, 1 / norm(other) * other);
    };
    mesh_.forEachOutgoing(mesh_.from(h), [&](Index out) {
      look(mesh_.to(out), !isFlatAcross(out));
      const Index back = ChangingMesh::previous(out);
      if (mesh_.twin(back) == kNoIndex) look(mesh_.from(back), true);
    });
    return !isAny || (isOnLine && isStraight);
  }

  /// Collapses an edge; what lay in the faces round its start lies in those that are left of them.
  Index remove(Index h) {
    const Index vertex = mesh_.from(h);
    std::vector<Index> faces, points{vertex};
    mesh_.forEachOutgoing(vertex, [&](Index out) {
      faces.push_back(out / 3);
      for (Index p = first_[out / 3]; p != kNoIndex; p = next_[p]) points.push_back(p);
      first_[out / 3] = kNoIndex;
    });
    const Index left = mesh_.collapse(h, mesh_.position(mesh_.to(h)));
    std::erase_if(faces, [&](Index face) { return !mesh_.isAlive(face); });
    for (const Index point : points) {
      double least = std::numeric_limits<double>::infinity();
      Index nearest = kNoIndex;
      for (const Index face : faces) {
        const TrianglePoint found = placeIn(face, point);
        const Vec3 away = found.position - original_.position(Vertex(point));
        const double distance = dot(away, away);
        if (!(distance < least)) continue;
        least = distance;
        nearest = face;
        places_[point] = SurfacePoint::inFace(Face(face), found.weights);
      }
      next_[point] = first_[nearest];
      first_[nearest] = point;
    }
    return left;
  }

  TrianglePoint placeIn(Index face, Index point) const {
    const auto corner = [&](Index k) { return mesh_.position(mesh_.from(3 * face + k)); };
    return nearestInTriangle(original_.position(Vertex(point)), {corner(0), corner(1), corner(2)});
  }

  Result<LeanSurface> collect() {
    auto result = remeshing::resultOf(mesh_, lookout_,
                                      [](Index v) { return SurfacePoint::atVertex(Vertex(v)); });
    if (!result) return result.error();
    Index face = 0;
    for (Index f = 0; f < original_.faceCount(); ++f) {
      if (!mesh_.isAlive(f)) continue;
      for (Index p = first_[f]; p != kNoIndex; p = next_[p]) places_[p].element = face;
      ++face;
    }
    const std::vector<SurfacePoint>& kept = result.value().onOriginal;
    for (Index v = 0; v < kept.size(); ++v) {
      places_[kept[v].element] = SurfacePoint::atVertex(Vertex(v));
    }
    return LeanSurface{std::move(result.value().mesh), std::move(places_)};
  }

  const SurfaceMesh& original_;
  double turn_;
  Lookout lookout_;
  ChangingMesh mesh_;
  std::vector<Vec3> planes_;          // the unit normals of the original faces
  std::vector<Index> first_, next_;   // lists of the vertices that have gone, by their faces
  std::vector<SurfacePoint> places_;  // of these
};

}  // namespace

Result<LeanSurface> withoutFlatVertices(const SurfaceMesh& mesh, double turn,
                                        const ExecutionContext& context) {
  return FlatVertices(mesh, turn, context).run();
}

}  // namespace girth
