// The faces laid flat: each has a planar frame of its own, and crossing an edge is one rigid
// motion.
//
// In the frame of face f, corner 0 lies at the origin and side 0 along the x axis; the face is
// counter- clockwise. Only + − × ÷ √ are used, so every platform gets the same bits.
#pragma once

#include <cmath>
#include <vector>

#include "geodesic/tolerances.h"
#include "girth/surface_mesh.h"
#include "mesh/angles.h"

namespace girth::geodesic {

struct Vec2 {
  double x{0}, y{0};
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Positive where b lies to the left of a.
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double norm(Vec2 a) { return std::sqrt(dot(a, a)); }

/// One side of a face, in the frame of that face, and the way across it.
struct Side {
  Vec2 start;        ///< where the halfedge starts
  Vec2 direction;    ///< unit vector along it
  double length;     ///< its length
  Vec2 rotation;     ///< (cos, sin) of the motion into the frame of the twin's face
  Vec2 translation;  ///< and its shift
  Index twin;        ///< the halfedge on the other side
  Index from;        ///< the vertex where it starts

  Vec2 at(double t) const { return start + t * direction; }
  Vec2 toTwin(Vec2 p) const {
    return {rotation.x * p.x - rotation.y * p.y + translation.x,
            rotation.y * p.x + rotation.x * p.y + translation.y};
  }
};

/// A surface prepared for unfolding. Immutable: shared by the solvers of all threads.
class Unfolding {
 public:
  explicit Unfolding(const SurfaceMesh& mesh);

  const SurfaceMesh& mesh() const { return *mesh_; }
  /// The frames measure in `unit()` model units, a power of two near the mean edge length.
  double unit() const { return unit_; }
  double meanEdgeLength() const { return meanEdgeLength_; }

  const Side& side(Index halfedge) const { return sides_[halfedge]; }
  /// Direction of a halfedge at the vertex it starts from: its angle, counter-clockwise, from
  /// mesh().outgoing(vertex), in [0, totalAngle).
  double direction(Index halfedge) const { return direction_[halfedge]; }
  /// Total angle of a vertex.
  double totalAngle(Index vertex) const { return mesh_->totalAngle(vertex); }
  /// Whether geodesics can pass through a vertex: it is not convex.
  bool passable(Index vertex) const { return passable_[vertex] != 0; }
  /// Whether windows start anew at a vertex: it is a saddle.
  bool saddle(Index vertex) const { return passable_[vertex] == 2; }

  /// Whether a path that arrives at a vertex from one direction and leaves in another is locally
  /// shortest there: both sides leave an angle of at least π (DEFINITIONS section 1).
  bool straight(Index vertex, double directionA, double directionB) const {
    const double between = std::fabs(directionA - directionB);
    return between >= kPi - kStraight && totalAngle(vertex) - between >= kPi - kStraight;
  }

  /// Direction at the vertex where `halfedge` starts of a point of its face, given in the frame.
  double directionTo(Index halfedge, Vec2 point) const {
    const Side& s = sides_[halfedge];
    const Vec2 d = point - s.start;
    const double y = cross(s.direction, d);
    return direction_[halfedge] + angleOf(dot(s.direction, d), y > 0 ? y : 0);
  }

 private:
  const SurfaceMesh* mesh_;
  double unit_, meanEdgeLength_;
  std::vector<Side> sides_;
  std::vector<double> direction_;
  std::vector<std::uint8_t> passable_;
};

}  // namespace girth::geodesic
