// A window: all the geodesics from the source that cross one sequence of faces (paper,
// section 4.1).
#pragma once

#include "geodesic/unfolding.h"

namespace girth::geodesic {

/// The geodesics arrive at `halfedge` and enter its face. Laid out flat in the frame of that face
/// they are straight lines from `root`, the image of the last vertex that they pass, and cross the
/// halfedge between `gapFrom` from its start and `gapTo` from its end. (Measured from its own end
/// of the edge, each gap is exactly zero where the window reaches that vertex, however often it is
/// unfolded.)
struct Window {
  Vec2 root;
  double sigma;    ///< distance from the source to the root
  double gapFrom;  ///< from the start of the halfedge to the window
  double gapTo;    ///< from the window to the end of the halfedge
  Index halfedge;
  Index parent;  ///< the window that it continues; kNoIndex: it starts at a vertex, `rootVertex`
  Index rootVertex;  ///< the last vertex passed
  Index sibling;     ///< the next window in the list of its halfedge

  /// Length of the path from the source to a point of the face.
  double distanceTo(Vec2 point) const { return sigma + norm(point - root); }

  /// Whether the straight line from the root to a point beyond the edge passes through the window,
  /// give or take kTouch of the edge.
  bool covers(const Side& side, Vec2 point) const {
    const Vec2 ray = point - root;
    const double slack = kTouch * side.length * (std::fabs(ray.x) + std::fabs(ray.y));
    return cross(side.at(gapFrom) - root, ray) <= slack &&
           cross(side.at(side.length - gapTo) - root, ray) >= -slack;
  }
};

}  // namespace girth::geodesic
