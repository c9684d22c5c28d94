// Exact geodesic distances by the algorithm of the textbooks: continuous Dijkstra over intervals of
// edges (Mitchell, Mount and Papadimitriou 1987, as implemented by Surazhsky et al. 2005). A method
// of its own to judge the engine by: it shares no code with it, calculates in long double from the
// positions, keeps the lower envelope of all windows on every edge, and whatever it answers is the
// length of a path on the surface, so that no tolerance can make it too short.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth::test {

/// Distances from one point of a surface to all others. The mesh must outlive it.
class TextbookMmp {
 public:
  explicit TextbookMmp(const SurfaceMesh& mesh);

  /// Starts again from a vertex, a point of an edge or a point inside a face. Distances up to
  /// `radius` are exact afterwards; greater ones are lengths of paths that may not be shortest, or
  /// infinite.
  void propagate(const SurfacePoint& source,
                 double radius = std::numeric_limits<double>::infinity());

  /// Distance of any surface point; infinite in another component.
  double distanceTo(const SurfacePoint& point) const;
  /// The distance to a point in the plane of a face: corner 0 at the origin, side 0 along x, corner
  /// 2 above.
  double distanceTo(Index face, double x, double y) const;

  /// The least distance on an edge, as far as the propagation has reached it; else infinite.
  double leastOn(Index halfedge) const;

  /// Where the corners of a face lie in its plane.
  std::array<std::array<double, 2>, 3> corners(Index face) const;

  /// Windows made by the last propagation.
  std::size_t windowCount() const { return windows_.size(); }

 private:
  using Real = long double;
  struct Point {
    Real x, y;
  };

  /// An interval of an edge, and the paths that reach it: straight from `root`, unfolded into the
  /// plane, whose own distance is `sigma`. The edge lies on the x axis; only how far the root is
  /// from that axis is kept, and through which face the paths come.
  struct Window {
    Real from, to;
    Real x, y;  // the root; y ≥ 0
    Real sigma;
    Index edge;
    Index through;  // halfedge of the edge in the face that the paths come through; kNoIndex: along
    bool done;      // handed on to the next face
    bool dead;      // nothing left of it
  };
  using WindowId = std::uint32_t;

  struct Event {
    Real distance;
    Index vertex;  // kNoIndex: a window
    WindowId window;
    bool operator<(const Event& other) const { return distance > other.distance; }
  };
  /// A part of an edge and whose it is.
  struct Part {
    Real from, to;
    WindowId owner;
  };

  static Real along(const Window& window, Real x);
  /// Length of a path to a point beyond the edge, through the window or round its end.
  static Real beyond(const Window& window, Point root, Real from, Real to, Point target);
  static void crossings(const Window& a, const Window& b, Real from, Real to,
                        std::vector<Real>& cuts);

  Point apex(Index halfedge) const { return apex_[halfedge]; }
  Point inPlaneOfNext(Index halfedge, Point point) const;
  /// The point in the plane of side 0 of its face.
  Point inPlaneOfFirst(Index halfedge, Point point) const;
  Real distanceInPlane(Index face, Point point) const;

  void lower(Index vertex, Real distance);
  void leaveVertex(Index vertex);
  void leaveInside(Index face, Point point);
  void handOn(WindowId window);
  void insertThrough(Index halfedge, Real from, Real to, Point root, Real sigma);
  void insertAlong(Index halfedge, Real root, Real sigma);
  void insert(const Window& window);
  WindowId add(Window window);

  const SurfaceMesh& mesh_;
  // The surface.
  std::vector<Point> apex_;  // the third corner, in the plane of each halfedge
  std::vector<Real> length_;
  std::vector<Index> edgeOf_, halfedgeOf_;
  std::vector<Index> firstOutgoing_, outgoing_;  // halfedges by vertex
  std::vector<bool> sendsOn_;                    // vertices whose surroundings are lit from them
  // The field.
  std::vector<Real> distance_;
  std::vector<Window> windows_;
  std::vector<std::vector<WindowId>> onEdge_;  // disjoint, in order
  std::vector<Index> touchedEdges_, touchedVertices_;
  std::priority_queue<Event> queue_;
  std::vector<std::pair<Index, Point>> sourceInPlane_;
  // Scratch memory.
  std::vector<Part> parts_;
  std::vector<Real> cuts_;
  std::vector<WindowId> list_;
};

}  // namespace girth::test
