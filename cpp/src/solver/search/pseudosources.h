// The pseudosources of a face: the points from which shortest paths run straight into it. The
// distance from p at a point of the face is the least over them (Mitchell, Mount and Papadimitriou
// 1987). Points farthest from p, and local maxima of the distance, are found among them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geodesic/propagation.h"

namespace girth {

/// A point from which paths run straight into a face, in the plane of the face: the root of a
/// window, or a corner from which paths start anew.
struct Pseudosource {
  geodesic::Vec2 root;
  double sigma;
  geodesic::Vec2 left{0, 0},
      right{0, 0};  // unit vectors along the bounds of the window; zero: unbounded
  /// The number of the corner; kNoIndex where it is no corner.
  Index corner{kNoIndex};

  double distanceTo(geodesic::Vec2 q) const { return sigma + norm(q - root); }
  /// Whether the window covers a point of this disk.
  bool meetsDisk(geodesic::Vec2 centre, double radius) const {
    return cross(left, centre - root) <= radius && cross(right, centre - root) >= -radius;
  }
};

/// Fills `sources` with the pseudosources of a face, in the frame of its first halfedge. Windows
/// whose paths into the face are all clearly longer than `longest` are left out.
void findPseudosources(const geodesic::Propagation& propagation, Index face, double longest,
                       std::vector<Pseudosource>& sources);

/// Adds one pseudosource of each root to `roots`, which must be empty. Windows that differ only in
/// how they pass flat vertices, within `slack`, count once. False: there are more than `most`.
bool differentRoots(const std::vector<Pseudosource>& sources, double slack, std::size_t most,
                    std::vector<Pseudosource>& roots);

/// The corners of a face in the frame of its first halfedge.
std::array<geodesic::Vec2, 3> cornersOf(const geodesic::Unfolding& unfolding, Index face);

/// The points at one distance from three pseudosources: |q − r_i| + σ_i = D for all three (the
/// problem of Apollonius). There are at most two.
int meetingPoints(const Pseudosource& a, const Pseudosource& b, const Pseudosource& c,
                  std::array<geodesic::Vec2, 2>& points);

/// The point of a face nearest to one that lies in it up to kTouch, both in the frame of its first
/// halfedge; nothing where it is farther out. (Beyond the tip of a needle, a point beside both
/// sides by as little may be far off.)
std::optional<geodesic::Vec2> withinFace(const geodesic::Propagation& propagation, Index face,
                                         geodesic::Vec2 q);

}  // namespace girth
