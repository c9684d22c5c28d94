// Geodesics by enumeration, with no pruning but their length: slow, and nothing in it to get wrong
// that the engine shares. From positions alone, in extended precision, so that coordinates rounded
// to twelve digits are in general position: no path runs exactly through a flat or convex vertex.
// For small meshes.
#pragma once

#include <optional>
#include <vector>

#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth::test {

/// All geodesics that start at one vertex, up to a length.
class BruteForce {
 public:
  /// Gives up, `complete() == false`, where there are more than `limit` sequences of faces.
  BruteForce(const SurfaceMesh& mesh, Index source, double longest, std::size_t limit = 2'000'000);

  bool complete() const { return complete_; }

  /// Length of the shortest geodesic to a point, in the plane of its face (corner 0 at the origin,
  /// side 0 along x); infinite beyond `longest`.
  double distanceTo(Index face, double x, double y) const;
  /// The distance to a surface point.
  double distanceTo(const SurfacePoint& point) const;

  /// A geodesic loop through the source: straight everywhere but there.
  struct Loop {
    double length;
    /// By which share of half the length a path to its midpoint is shorter than its halves; not
    /// above 0: both are shortest.
    double excess;
    /// Such a share of the next path that arrives from elsewhere, negative where that is longer:
    /// near 0 a third path arrives at the same time.
    double third;
    /// Its midpoint lies so near to a convex vertex that rounding decides whether it is a loop, or
    /// cannot be placed, as on a line that runs along edges.
    bool doubtful;
  };
  /// All of them up to `longest`, the shortest first.
  std::vector<Loop> loops() const;

  /// The shortest geodesic loop through the source whose halves are both shortest; nothing up to
  /// `longest`.
  std::optional<double> shortestLoop() const;

 private:
  using Real = long double;
  struct Point {
    Real x, y;
  };
  /// Straight lines from `root` into a face through one halfedge, which lies on the x axis.
  struct Cone {
    Index halfedge;
    Point root;
    Real sigma, b0, b1;
    std::size_t parent;   // the cone it continues, or kNone
    std::size_t arrival;  // else the arrival at the vertex that it starts from
  };
  /// A geodesic that ends at a vertex, in a cone or along an edge.
  struct Arrival {
    Index vertex;
    Real length, direction;
    std::size_t cone;  // or kNone: along the edge from the vertex of `before`
    std::size_t before;
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// A point of a face, in the plane of one of its halfedges.
  struct Place {
    Index halfedge;
    Point point;
  };

  void measure();
  Point apex(Index halfedge) const;
  /// A point in the plane of the next halfedge of the face, from that of this one.
  Point inPlaneOfNext(Index halfedge, Point point) const;
  Real distanceInPlaneOf(Index halfedge, Point point) const;
  Real directionOf(Index halfedge) const;
  void leave(std::size_t arrival, Real start, Real width);
  void arrive(Index vertex, Real length, Real direction, std::size_t cone, std::size_t before);
  void grow(std::size_t cone);
  template <class Visit>
  void eachPathTo(Index halfedge, Point point, Visit visit) const;
  Place placeAlong(const Arrival& loop, Real length) const;
  bool meetsOthers(Index vertex, Real reach) const;

  const SurfaceMesh& mesh_;
  Index source_;
  Real longest_;
  std::vector<Real> lengths_, angles_;  // by halfedge: its length, and the angle at its start
  std::vector<Real> totals_;            // by vertex
  std::size_t limit_;
  bool complete_{true};
  std::vector<Cone> cones_;
  std::vector<Arrival> arrivals_;
  std::vector<std::size_t> todo_;
  std::vector<std::vector<std::size_t>> conesOfFace_;
};

}  // namespace girth::test
