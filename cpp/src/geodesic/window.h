// A window: all the geodesics from the source that cross one sequence of faces (paper,
// section 4.1).
#pragma once

#include "geodesic/min_max.h"
#include "geodesic/unfolding.h"

namespace girth::geodesic {

/// The geodesics arrive at a halfedge and enter its face. Laid out flat in the frame of that
/// halfedge they are straight lines from `root`, the image of the last vertex that they pass (or of
/// the source), which lies below; they cross the halfedge between `gapFrom` from its start and
/// `gapTo` from its end. (Measured from its own end of the edge, each gap is exactly zero where the
/// window reaches that vertex, however often it is unfolded.)
struct Window {
  Vec2 root;
  double sigma;  ///< distance from the source to the root
  double gapFrom, gapTo;

  /// Length of the straight path from the source to a point of the face that the window covers.
  double distanceTo(Vec2 point) const { return sigma + norm(point - root); }
  /// Length of a path from the source to a point of the face: the straight one where the window
  /// covers the point, else the one over the end of the window next to it. `length`: of the
  /// halfedge. A straight line beyond the end would leave the window's faces, and may be shorter
  /// than every path by as much as it passes beside the end.
  double pathTo(double length, Vec2 point) const {
    const Vec2 ray = point - root, from = Vec2{gapFrom, 0} - root,
               to = Vec2{length - gapTo, 0} - root;
    if (cross(from, ray) > 0) return sigma + norm(from) + norm(ray - from);
    if (cross(to, ray) < 0) return sigma + norm(to) + norm(ray - to);
    return sigma + norm(ray);
  }
  /// Where that path comes from: the root, or the vertex at the end of the window.
  Vec2 comesFrom(double length, Vec2 point) const {
    const Vec2 ray = point - root, from = Vec2{gapFrom, 0}, to = Vec2{length - gapTo, 0};
    if (gapFrom == 0 && cross(from - root, ray) > 0) return from;
    return gapTo == 0 && cross(to - root, ray) < 0 ? to : root;
  }

  /// Length of the shortest of its paths to the halfedge, of this length: to no point of the face
  /// that it covers is one shorter.
  double nearest(double length) const {
    return distanceTo({lesser(larger(root.x, gapFrom), length - gapTo), 0});
  }
  /// Whether all of them are longer than that, whatever rounding does.
  bool isSurelyLonger(double length, double distance) const {
    return nearest(length) > distance * (1 + 1e-6);
  }

  /// Whether the straight line from the root to a point above the halfedge (of this length) passes
  /// through the window, up to `slack`.
  bool covers(double length, Vec2 point) const {
    const Vec2 ray = point - root, from = Vec2{gapFrom, 0} - root,
               to = Vec2{length - gapTo, 0} - root;
    return cross(from, ray) <= slack(from, ray) && cross(to, ray) >= -slack(to, ray);
  }
  /// A line along `ray` passes an end of the window, which lies along `bound`, if their cross
  /// product is no more than this beyond.
  static double slack(Vec2 bound, Vec2 ray) {
    return kAim * (std::fabs(bound.x) + std::fabs(bound.y)) * (std::fabs(ray.x) + std::fabs(ray.y));
  }
};

/// A window of a propagation: its halfedge, and its number there.
struct WindowNumber {
  Index halfedge{kNoIndex};
  std::uint32_t number{0};
};

/// Where a bundle of straight paths comes from: a window without its bounds. It is all that remains
/// of a path when its windows are gone.
struct Bundle {
  Index halfedge{kNoIndex};
  Vec2 root;  ///< in the frame of the halfedge
  double sigma{0};
};

}  // namespace girth::geodesic
