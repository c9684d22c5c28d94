// Small formulas of crossing a face, the same for one window and for several side by side.
//
// T is double or a vector of doubles; all functions are local to the file that includes them (see
// lanes.h).
#pragma once

#include "geodesic/tolerances.h"

namespace girth::geodesic {
namespace {

template <class T>
struct Pair {
  T x, y;
};

/// A root, given in the frame of a halfedge, in the frame of the twin of the face's left side (it
/// runs from the halfedge's start to the apex); `ux`, `uy`: Crossing::left. For the right side,
/// look at it in the mirror: x → length − x before, and x → rightLength − x after.
template <class T, class U>
inline Pair<T> rootBeyond(T x, T y, U ux, U uy) {
  return {x * ux + y * uy, y * ux - x * uy};
}

/// Where a ray that passes the halfedge at `gap` from its start meets the left side, measured from
/// the same vertex; the root lies at (x, −height). By similar triangles, so that zero stays zero.
template <class T, class U>
inline T gapBeyond(T gap, T x, T height, U ux, U uy) {
  return gap * height / (height * ux + (x - gap) * uy);
}

/// How a path over a vertex V and along the line competes with a window: with V at the origin, the
/// line along x, the root at (x, y), and lead = distance(V) − sigma, the two lengths are equal at t
/// where lead + t = |root − t|: one point at most, t = excess / slope, and V wins on the near side
/// of it; where slope ≤ 0, V wins everywhere. (The margins let a window stay that lies along the
/// line and ties with V.)
template <class T>
struct Contest {
  T excess, slope;
};
template <class T>
inline Contest<T> contest(T x, T y, T lead) {
  return {(x * x + y * y) * (1 - kTrim) - lead * lead, 2 * (x + lead * (1 + kTrim))};
}

}  // namespace
}  // namespace girth::geodesic
