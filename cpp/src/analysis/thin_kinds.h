// Walls and creases: whether material is thin over an extent, or only where two faces run into each
// other.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "descriptors/facing_surface.h"
#include "girth/print_check.h"
#include "girth/surface_mesh.h"
#include "mesh/angles.h"
#include "mesh/nearest_point.h"
#include "mesh/vector.h"

namespace girth {

/// Up to this angle two faces oppose: 2 atan(1/3). A wedge of it is as thick as a limit at one and
/// a half limits from its edge.
inline constexpr double kOpposingAngle = 0.6435011087932844;
/// How far from thick material a crease reaches, in limits.
inline constexpr double kCreaseReach = 2;
/// How long and how thick a lip is at most, in limits.
inline constexpr double kLipReach = 1.0 / 8;
/// By how much two points of a surface may be nearer than in the shape that was written in single
/// precision, in the largest coordinate: 2 √3 · 2⁻²⁴.
inline constexpr double kSingleRounding = 3.4641016151377544 / (1 << 24);
/// Faces that are lower than so many roundings have no direction.
inline constexpr double kSliverRoundings = 4;

/// Judges balls below a limit (web/docs/definitions.md, Definition 5.7). Threads may share it.
class ThinKinds {
 public:
  /// `all`: with the sharp angle of the check; `opposing`: with kOpposingAngle or less. `values`:
  /// the thickness by `all` at the vertices. All must outlive it. `isGap`: of the space around,
  /// where faces that touch leave no gap.
  ThinKinds(const SurfaceMesh& mesh, const FacingSurface& all, const FacingSurface& opposing,
            std::span<const double> values, double limit, double rounding, bool isGap)
      : mesh_(mesh),
        all_(all),
        opposing_(opposing),
        values_(values),
        limit_(limit),
        rounding_(rounding),
        isGap_(isGap) {}

  /// The smallest ball of a wall in a face; infinite where all that is thin there is a crease.
  /// `least`: its smallest ball of all, below the limit.
  TouchingBall wallIn(Face face, const TouchingBall& least) const {
    bool hasLip = false;
    const auto counts = [&](const TouchingBall& ball) {
      if (reasonAgainst(face, ball)) return false;
      // A point of a lip belongs to no wall by a larger ball.
      const double lipReach = kLipReach * limit_;
      const bool lip = isLip(
          face, ball.diameter <= lipReach ? ball : opposing_.atPoint(face, ball.from, lipReach));
      hasLip |= lip;
      return !lip;
    };
    TouchingBall wall = opposing_.inFace(face, limit_, counts);
    if (wall.diameter < limit_) return wall;
    // There may be more to a lip's faces, and to a crease than an edge with thick material behind.
    std::vector<Vec3> known;
    TouchingBall left;
    const auto look = [&](const Vec3& p) {
      if (hasLip) {
        const TouchingBall ball = opposing_.atPoint(face, p, limit_);
        if (ball.diameter < wall.diameter && counts(ball)) wall = ball;
      }
      if (left.diameter < limit_) return;
      const TouchingBall ball = all_.atPoint(face, p, limit_);
      if (ball.diameter < limit_ && !ends(face, ball, known)) left = ball;
    };
    forEachSample(face, look);
    const bool isLeft = left.diameter < limit_ || !ends(face, least, known);
    if (isLeft && (least.diameter > rounding_ || !(left.diameter < limit_))) left = least;
    return left.diameter < wall.diameter && isLeft ? left : wall;
  }

  /// The thickness of a wall at a vertex whose thickness is below the limit; infinite where it is a
  /// crease.
  double wallAt(Vertex vertex) const {
    // At a sharp vertex its faces decide: they are as thin there.
    if (values_[vertex] <= 0) return std::numeric_limits<double>::infinity();
    std::vector<Face> faces;
    for (Halfedge h = mesh_.outgoing(vertex); h != Halfedge::none;) {
      faces.push_back(SurfaceMesh::faceOf(h));
      h = mesh_.twin(SurfaceMesh::previous(h));
      if (h == mesh_.outgoing(vertex)) break;
    }
    const TouchingBall ball = opposing_.atVertex(vertex);
    const auto all = [&](auto&& holds) { return std::all_of(faces.begin(), faces.end(), holds); };
    if (ball.diameter < limit_ && !reasonAgainst(faces.front(), ball) &&
        !all([&](Face face) { return isLip(face, ball); })) {
      return ball.diameter;
    }
    const bool isCrease = all([&](Face face) {
      std::vector<Vec3> known;
      return ends(face, {values_[vertex], mesh_.position(vertex), mesh_.position(vertex)}, known);
    });
    return isCrease ? std::numeric_limits<double>::infinity() : values_[vertex];
  }

  /// The kind of a crease whose smallest ball is in a face.
  CreaseKind kindOf(Face face, const TouchingBall& ball) const {
    return reasonAgainst(face, ball).value_or(CreaseKind::Crease);
  }

 private:
  static constexpr std::size_t kMostFaces = 4096;
  static constexpr std::size_t kMostPoints = 96;

  double longestSide(Face face) const {
    return std::max({mesh_.length(SurfaceMesh::side(face, 0)),
                     mesh_.length(SurfaceMesh::side(face, 1)),
                     mesh_.length(SurfaceMesh::side(face, 2))});
  }

  bool isSliver(Face face) const {
    return 2 * mesh_.area(face) < kSliverRoundings * rounding_ * longestSide(face);
  }

  bool meet(Face face, Face other) const {
    const auto corners = mesh_.faceVertices(face), others = mesh_.faceVertices(other);
    return std::any_of(corners.begin(), corners.end(), [&](Vertex v) {
      return std::find(others.begin(), others.end(), v) != others.end();
    });
  }

  /// Why a ball measures nothing, if it does not.
  std::optional<CreaseKind> reasonAgainst(Face face, const TouchingBall& ball) const {
    if (isSliver(face) || (ball.across != Face::none && isSliver(ball.across))) {
      return CreaseKind::Sliver;
    }
    if (ball.diameter > rounding_) return std::nullopt;
    if (ball.across != Face::none && meet(face, ball.across)) return std::nullopt;
    return CreaseKind::Rounding;
  }

  /// In a face, away from where it meets what a ball reaches.
  Vec3 awayFrom(Face face, const TouchingBall& ball) const {
    const std::array<Vec3, 3> corners = cornersOf(face);
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const Vec3 back = ball.from - ball.to;
    const Vec3 along = back - (dot(back, normal) / dot(normal, normal)) * normal;
    const double length = norm(along);
    return length > 0 ? (1 / length) * along : Vec3{};
  }

  /// Whether a thin place ends near a ball: at thick material on the same side of all creases round
  /// the body; or so near that creases that stick into it do not matter. `known`: where that was
  /// found from other points of the face.
  bool ends(Face face, const TouchingBall& ball, std::vector<Vec3>& known) const {
    if (isGap_ && ball.diameter <= rounding_) return true;
    const Vec3& p = ball.from;
    ThickSearch search{p, kCreaseReach * limit_, awayFrom(face, ball)};
    for (const Vec3& q : known) {
      if (norm(q - p) <= search.reach) return true;
    }
    if (isNearThick(face, false, search)) {
      known.push_back(*search.found);
      return true;
    }
    return isNearThick(face, p);
  }

  /// Looks for surface as thick as the limit within reach of a point.
  struct ThickSearch {
    Vec3 p;
    double reach;
    Vec3 away;                      ///< from where faces meet, as a unit vector; or 0
    std::size_t left{kMostPoints};  ///< points that may still be measured
    std::optional<Vec3> found{};
  };

  /// The point of a face nearest to another, measured where that is within reach.
  bool isThickAt(Face face, const std::array<Vec3, 3>& corners, const Vec3& p,
                 ThickSearch& search) const {
    const Vec3 at = nearestInTriangle(p, corners).position;
    if (norm(at - search.p) > (1 + 1e-9) * search.reach || search.left == 0) return false;
    --search.left;
    if (all_.atPoint(face, at, limit_).diameter < limit_) return false;
    search.found = at;
    return true;
  }

  bool hasThickCorner(Face face, ThickSearch& search) const {
    for (const Vertex v : mesh_.faceVertices(face)) {
      if (!(norm(mesh_.position(v) - search.p) <= search.reach) || values_[v] < limit_) continue;
      search.found = mesh_.position(v);
      return true;
    }
    return false;
  }

  /// Looks at a face away from where faces meet, and towards its middle.
  bool hasThickAhead(Face face, ThickSearch& search) const {
    const std::array<Vec3, 3> corners = cornersOf(face);
    if (dot(search.away, search.away) > 0 &&
        isThickAt(face, corners, search.p + search.reach * search.away, search)) {
      return true;
    }
    const Vec3 foot = nearestInTriangle(search.p, corners).position;
    const Vec3 inward = (1.0 / 3) * (corners[0] + corners[1] + corners[2]) - foot;
    const double most = search.reach - norm(foot - search.p), far = norm(inward);
    return far > 0 && isThickAt(face, corners, foot + std::min(1.0, most / far) * inward, search);
  }

  /// Looks at a face in all directions from p.
  bool hasThickRound(Face face, ThickSearch& search) const {
    const std::array<Vec3, 3> corners = cornersOf(face);
    const Vec3 u = (1 / norm(corners[1] - corners[0])) * (corners[1] - corners[0]);
    const Vec3 rest = corners[2] - corners[0];
    const Vec3 across = rest - dot(rest, u) * u;
    const Vec3 v = (1 / norm(across)) * across;
    for (const double share : {1.0, 0.5}) {
      if (search.left == 0) return false;
      for (int k = 0; k < 12; ++k) {
        const CosSin turn = cosSin(k * kPi / 12);
        const Vec3 step = share * search.reach * (turn.cos * u + turn.sin * v);
        if (isThickAt(face, corners, search.p + step, search) ||
            isThickAt(face, corners, search.p - step, search)) {
          return true;
        }
      }
    }
    return false;
  }

  /// Whether surface as thick as the limit lies within reach of p, on the way over faces near p
  /// from `face` on, across smooth edges; across creases that stick into the body too if `inward`.
  bool isNearThick(Face face, bool inward, ThickSearch& search) const {
    std::vector<Face> reached{face};
    std::unordered_set<Index> seen{face};
    for (std::size_t i = 0; i < reached.size() && i < kMostFaces; ++i) {
      if (hasThickCorner(reached[i], search)) return true;
      for (Index k = 0; k < 3; ++k) {
        const Halfedge h = SurfaceMesh::side(reached[i], k), twin = mesh_.twin(h);
        if (twin == Halfedge::none) continue;
        const FacingSurface::Bend bend = all_.bendAt(h);
        if (bend == FacingSurface::Bend::Outward) continue;
        if (bend == FacingSurface::Bend::Inward && !inward) continue;
        const Face next = SurfaceMesh::faceOf(twin);
        if (distance(next, search.p) <= search.reach && seen.insert(next).second) {
          reached.push_back(next);
        }
      }
    }
    // Corners stand for what small faces have.
    std::erase_if(reached,
                  [&](Face each) { return each != face && longestSide(each) < search.reach / 4; });
    const auto any = [&](auto&& has) { return std::any_of(reached.begin(), reached.end(), has); };
    return any([&](Face each) { return hasThickAhead(each, search); }) ||
           any([&](Face each) { return hasThickRound(each, search); });
  }

  /// Whether thick surface is as near as the length of a lip.
  bool isNearThick(Face face, const Vec3& p) const {
    ThickSearch search{p, kLipReach * limit_, {}};
    return isNearThick(face, true, search);
  }

  std::array<Vec3, 3> cornersOf(Face face) const {
    const auto [a, b, c] = mesh_.faceVertices(face);
    return {mesh_.position(a), mesh_.position(b), mesh_.position(c)};
  }

  double distance(Face face, const Vec3& p) const {
    return norm(nearestInTriangle(p, cornersOf(face)).position - p);
  }

  /// Whether a ball lies in a lip: no longer and no thicker than kLipReach, thick behind on both
  /// sides, and closed round its end. So it holds nothing together, as a neck or a thin spot does.
  bool isLip(Face face, const TouchingBall& ball) const {
    const double reach = kLipReach * limit_;
    if (!(ball.diameter <= reach) || ball.across == Face::none) return false;
    if (!isDisc(face, ball, reach + ball.diameter / 2)) return false;
    return isNearThick(face, ball.from) && isNearThick(ball.across, ball.to);
  }

  /// Whether the faces round a ball that hang together with `face` reach the other side of it, and
  /// make one disc.
  bool isDisc(Face face, const TouchingBall& ball, double radius) const {
    const Vec3 middle = 0.5 * (ball.from + ball.to);
    std::vector<Face> found{face};
    std::unordered_set<Index> seen{face}, vertices;
    std::size_t sides = 0, shared = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (i > kMostFaces) return false;
      for (const Vertex v : mesh_.faceVertices(found[i])) vertices.insert(v);
      for (Index k = 0; k < 3; ++k) {
        const Halfedge twin = mesh_.twin(SurfaceMesh::side(found[i], k));
        if (twin == Halfedge::none) return false;
        const Face next = SurfaceMesh::faceOf(twin);
        if (distance(next, middle) <= radius && seen.insert(next).second) found.push_back(next);
      }
    }
    if (!seen.contains(ball.across)) return false;
    for (const Face f : found) {
      for (Index k = 0; k < 3; ++k) {
        ++sides;
        shared += seen.contains(SurfaceMesh::faceOf(mesh_.twin(SurfaceMesh::side(f, k)))) ? 1 : 0;
      }
    }
    // Euler's characteristic of what is connected.
    return vertices.size() + found.size() == sides - shared / 2 + 1;
  }

  /// Points of a face, about half a limit apart, but no more than 64.
  template <class Look>
  void forEachSample(Face face, Look&& look) const {
    const auto [a, b, c] = mesh_.faceVertices(face);
    const double longest = longestSide(face);
    int parts = 1;
    while (parts < 8 && longest > limit_ / 2 * parts) parts *= 2;
    const Vec3 corner = mesh_.position(a);
    const Vec3 u = (1.0 / parts) * (mesh_.position(b) - corner),
               v = (1.0 / parts) * (mesh_.position(c) - corner);
    for (int i = 0; i < parts; ++i) {
      for (int k = 0; i + k < parts; ++k) {
        const Vec3 at = corner + static_cast<double>(i) * u + static_cast<double>(k) * v;
        look(at + (1.0 / 3) * (u + v));
        if (i + k + 2 <= parts) look(at + (2.0 / 3) * (u + v));
      }
    }
  }

  const SurfaceMesh& mesh_;
  const FacingSurface& all_;
  const FacingSurface& opposing_;
  std::span<const double> values_;
  double limit_;
  double rounding_;
  bool isGap_;
};

}  // namespace girth
