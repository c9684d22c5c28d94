// Where shortest paths into a face come from: what its points compete for when the points farthest
// from p, or from all points near by, are looked for.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geodesic/propagation.h"

namespace girth {

/// Where paths into a face come from, in the plane of the face: the root of a window, or a corner
/// that sends out paths of its own.
struct Site {
  geodesic::Vec2 root;
  double sigma;
  geodesic::Vec2 left{0, 0},
      right{0, 0};  // unit vectors along the bounds of the window; zero: unbounded
  /// Of a corner, its number; none: it is no corner.
  Index corner{kNoIndex};

  double distanceTo(geodesic::Vec2 q) const { return sigma + norm(q - root); }
  /// Whether the window covers a point of this disk.
  bool meetsDisk(geodesic::Vec2 centre, double radius) const {
    return cross(left, centre - root) <= radius && cross(right, centre - root) >= -radius;
  }
};

/// The sites of a face, in the frame of its first halfedge: `sites` is filled in anew. Windows
/// whose paths into the face are all longer than `longest` are left out, but for some that are
/// hardly longer.
void findSites(const geodesic::Propagation& propagation, Index face, double longest,
               std::vector<Site>& sites);

/// Adds one site of each root to `roots`, which must come empty: windows that differ only in the
/// way they pass flat vertices, within `slack`, count once. False: there are more than `most`.
bool differentRoots(const std::vector<Site>& sites, double slack, std::size_t most,
                    std::vector<Site>& roots);

/// The corners of a face in the frame of its first halfedge.
std::array<geodesic::Vec2, 3> cornersOf(const geodesic::Unfolding& unfolding, Index face);

/// The points at which three sites are at one distance: |q − r_i| + σ_i = D for all three (the
/// problem of Apollonius); up to two of them.
int meetingPoints(const Site& a, const Site& b, const Site& c,
                  std::array<geodesic::Vec2, 2>& points);

/// The point of a face nearest to one that lies in it up to kTouch, both in the frame of its first
/// halfedge; nothing where it is farther out. (Beyond the tip of a needle, a point beside both
/// sides by as little may be far off.)
std::optional<geodesic::Vec2> withinFace(const geodesic::Propagation& propagation, Index face,
                                         geodesic::Vec2 q);

}  // namespace girth
