#include "mesh/flat_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "mesh/face_shape.h"
#include "mesh/nearest_point.h"
#include "mesh/remesh/cancellation_poll.h"
#include "mesh/remesh/changing_mesh.h"
#include "mesh/remesh/face_checks.h"
#include "mesh/remesh/result.h"
#include "mesh/vertex_normals.h"

namespace girth {

namespace {

using remeshing::CancellationPoll;
using remeshing::ChangingMesh;

/// The shape of a face is 1 where its sides are equal, and 0 where it has no area. It may become
/// worse down to this.
constexpr double kPoorShape = 0.05;
/// A vertex that has gone lies on a side of a face where rounding may have put it beside that, but
/// no farther than this share of the height above.
constexpr double kOnSide = 0.1;
/// Surfaces with larger coordinates, or only smaller ones than the inverse, stay as they are:
/// fourth powers of lengths must neither overflow nor vanish.
constexpr double kLargest = 1e60;
/// Both ends of a line may be off by the rounding, and each of two lines to be compared.
constexpr double kSlack = 2;
/// No face or boundary turns by more than this: the sine of the angle.
constexpr double kMostTurn = 0.05;

double shapeOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  const double squares = dot(ab, ab) + dot(bc, bc) + dot(ca, ca);
  return squares > 0 ? 2 * std::sqrt(3.0) * norm(cross(ab, bc)) / squares : 0;
}

class FlatVertices {
 public:
  FlatVertices(const SurfaceMesh& original, double rounding, const ExecutionContext& context)
      : original_(original),
        extent_(extentOf(original)),
        poll_(context),
        mesh_(original),
        planes_(normalsOfFaces(original)),
        first_(original.faceCount(), kNoIndex),
        next_(original.vertexCount(), kNoIndex),
        places_(original.vertexCount()) {
    off_ = kSlack * rounding * extent_;
    for (const Face f : original.faces()) turns_.push_back(turnOf(f));
  }

  Result<LeanSurface> run() {
    std::deque<Index> queue;
    std::vector<bool> isQueued(original_.vertexCount(), true);
    if (isOfOrdinarySize()) {
      for (const Vertex v : original_.vertices()) queue.push_back(v);
    }
    while (!queue.empty()) {
      if (poll_.stopped()) return CancellationPoll::error();
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
  bool isOfOrdinarySize() const { return extent_ <= kLargest && extent_ >= 1 / kLargest; }

  /// How far rounding turns a face.
  double turnOf(Face face) const {
    const auto [a, b, c] = original_.faceVertices(face);
    const double longest = std::max({norm(original_.position(b) - original_.position(a)),
                                     norm(original_.position(c) - original_.position(b)),
                                     norm(original_.position(a) - original_.position(c))});
    return std::min(kMostTurn, off_ * longest / (2 * original_.area(face)));
  }

  /// The edge along which a vertex can go, so that the worst face that is left has the best shape.
  std::optional<Index> bestWay(Index vertex) const {
    std::vector<std::pair<double, Index>> ways;
    mesh_.forEachOutgoing(vertex, [&](Index h) {
      const double shape = shapeAfter(h);
      if (shape > 0) ways.emplace_back(shape, h);
    });
    std::sort(ways.begin(), ways.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    for (const auto& [shape, h] : ways) {
      if (keepsLines(h) && mesh_.canCollapse(h) && keepsPoints(h)) return h;
    }
    return std::nullopt;
  }

  /// Whether a vector has the direction of a unit vector, but for an angle of this sine.
  static bool isAlong(const Vec3& vector, const Vec3& direction, double turn) {
    return dot(vector, direction) > 0 && norm(cross(vector, direction)) <= turn * norm(vector);
  }
  /// Whether there are faces on both sides of an edge, and both lie in one plane.
  bool isFlatAcross(Index h) const {
    const Index twin = mesh_.twin(h);
    return twin != kNoIndex &&
           isAlong(planes_[h / 3], planes_[twin / 3], turns_[h / 3] + turns_[twin / 3]);
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
      const Index face = out / 3;
      after = isAlong(area, planes_[face], turns_[face]) && remeshing::hasArea(place, pb, pc)
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
      const double turn = std::min(kMostTurn, off_ / norm(one) + off_ / norm(other));
      isStraight = isStraight && isAlong(one, 1 / norm(other) * other, turn);
    };
    mesh_.forEachOutgoing(mesh_.from(h), [&](Index out) {
      look(mesh_.to(out), !isFlatAcross(out));
      const Index back = ChangingMesh::previous(out);
      if (mesh_.twin(back) == kNoIndex) look(mesh_.from(back), true);
    });
    return !isAny || (isOnLine && isStraight);
  }

  /// A vertex that has gone, in the face that is nearest to it.
  struct Place {
    Index face{kNoIndex};
    std::array<double, 3> weights{};
    double squaredDistance{std::numeric_limits<double>::infinity()};
  };

  /// Calls `visit(vertex, place)` for the start of an edge and all vertices that have gone into its
  /// faces: where they are after it has gone to the end of the edge.
  template <class Visit>
  void eachPlaceAfter(Index h, Visit visit) const {
    const Index vertex = mesh_.from(h), to = mesh_.to(h);
    const auto placeAfter = [&](Index point) {
      const Vec3& position = original_.position(Vertex(point));
      Place place;
      mesh_.forEachOutgoing(vertex, [&](Index out) {
        if (mesh_.to(out) == to || mesh_.apex(out) == to) return;
        // The corners in the order of the face.
        std::array<Vec3, 3> corners;
        for (Index k = 0; k < 3; ++k) {
          const Index corner = mesh_.from(3 * (out / 3) + k);
          corners[k] = mesh_.position(corner == vertex ? to : corner);
        }
        const TrianglePoint found = nearestInTriangle(position, corners);
        const Vec3 away = found.position - position;
        const double distance = dot(away, away);
        if (distance < place.squaredDistance) place = {out / 3, found.weights, distance};
      });
      return place;
    };
    visit(vertex, placeAfter(vertex));
    mesh_.forEachOutgoing(vertex, [&](Index out) {
      for (Index p = first_[out / 3]; p != kNoIndex; p = next_[p]) visit(p, placeAfter(p));
    });
  }

  bool keepsPoints(Index h) const {
    bool keeps = true;
    eachPlaceAfter(h, [&](Index, const Place& place) {
      keeps = keeps && place.squaredDistance <= off_ * off_;
    });
    return keeps;
  }

  /// Collapses an edge; what lay in the faces round its start lies in those that are left of them.
  Index remove(Index h) {
    std::vector<std::pair<Index, Index>> faceOf;
    eachPlaceAfter(h, [&](Index point, const Place& place) {
      faceOf.emplace_back(point, place.face);
      places_[point] = SurfacePoint::inFace(Face(place.face), place.weights);
    });
    mesh_.forEachOutgoing(mesh_.from(h), [&](Index out) { first_[out / 3] = kNoIndex; });
    const Index left = mesh_.collapse(h, mesh_.position(mesh_.to(h)));
    for (const auto& [point, face] : faceOf) {
      next_[point] = first_[face];
      first_[face] = point;
    }
    return left;
  }

  /// A point of a face; on a side of it where it may be that far off.
  SurfacePoint onSide(const SurfaceMesh& mesh, Face face,
                      const std::array<double, 3>& weights) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Halfedge side(3 * face + static_cast<Index>(k));
      const double height = 2 * mesh.area(face) / mesh.length(side), above = weights[(k + 2) % 3];
      if (above > kOnSide || above * height > 2 * off_) continue;
      const double start = weights[k], end = weights[(k + 1) % 3];
      return SurfacePoint::onHalfedge(side, end / (start + end));
    }
    return SurfacePoint::inFace(face, weights);
  }

  Result<LeanSurface> collect() {
    auto result = remeshing::resultOf(mesh_, poll_,
                                      [](Index v) { return SurfacePoint::atVertex(Vertex(v)); });
    if (!result) return result.error();
    Index face = 0;
    for (Index f = 0; f < original_.faceCount(); ++f) {
      if (!mesh_.isAlive(f)) continue;
      for (Index p = first_[f]; p != kNoIndex; p = next_[p]) {
        places_[p] = onSide(result.value().mesh, Face(face), places_[p].weights);
      }
      ++face;
    }
    const std::vector<SurfacePoint>& kept = result.value().onOriginal;
    for (Index v = 0; v < kept.size(); ++v) {
      places_[kept[v].element] = SurfacePoint::atVertex(Vertex(v));
    }
    return LeanSurface{std::move(result.value().mesh), std::move(places_)};
  }

  const SurfaceMesh& original_;
  double extent_;  // the size of the largest coordinate
  CancellationPoll poll_;
  ChangingMesh mesh_;
  double off_{0};                     // how far a vertex may lie beside where it ought to
  std::vector<Vec3> planes_;          // the unit normals of the original faces
  std::vector<double> turns_;         // angles by which these normals may be turned
  std::vector<Index> first_, next_;   // lists of the vertices that have gone, by their faces
  std::vector<SurfacePoint> places_;  // places of the vertices that have gone
};

}  // namespace

Result<LeanSurface> withoutFlatVertices(const SurfaceMesh& mesh, double rounding,
                                        const ExecutionContext& context) {
  return FlatVertices(mesh, rounding, context).run();
}

}  // namespace girth
