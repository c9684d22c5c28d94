// From a point back to the source along the path that a propagation found.
#pragma once

#include <vector>

#include "geodesic/propagation.h"
#include "girth/surface_point.h"

namespace girth::geodesic {

/// Appends the points of the path of a window, from `point` (a point of the window's face, in its
/// frame; itself left out) back to the source: the halfedges crossed, the vertices passed, the
/// source.
void traceFromWindow(const Propagation& propagation, Index window, Vec2 point,
                     std::vector<SurfacePoint>& path);

/// The same for the best path to a vertex, which itself comes first.
void traceFromVertex(const Propagation& propagation, Index vertex, std::vector<SurfacePoint>& path);

/// Whether two points are one, up to kTouch. Points on edges are told by the smaller of the two
/// halfedges.
bool samePoint(const SurfacePoint& a, const SurfacePoint& b);

/// A point of a face, given in its frame, as a surface point; snapped to an edge or corner within
/// kTouch.
SurfacePoint surfacePointAt(const Unfolding& unfolding, Index face, Vec2 point);

}  // namespace girth::geodesic
