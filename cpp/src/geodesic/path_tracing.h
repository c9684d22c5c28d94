// From a point back to the source along the path that a propagation found.
#pragma once

#include <vector>

#include "geodesic/propagation.h"
#include "girth/surface_point.h"

namespace girth::geodesic {

/// Appends the points of the path that a bundle takes to `point` (in the frame of its halfedge,
/// above it or on it; itself left out) back to the source: the halfedges crossed, the vertices
/// passed, the source. Needs Keep::Everything.
///
/// Windows do not note which window they continue. It is found again behind the halfedge: the one
/// whose root unfolds to the same bits.
void traceBundle(const Propagation& propagation, Bundle bundle, Vec2 point,
                 std::vector<SurfacePoint>& path);

/// Traces the best path to a vertex, which itself comes first.
void traceVertex(const Propagation& propagation, Index vertex, std::vector<SurfacePoint>& path);

/// Traces the path that `Propagation::pathTo(halfedge, point)` found.
void tracePath(const Propagation& propagation, const PathEnd& end, Index halfedge, Vec2 point,
               std::vector<SurfacePoint>& path);

/// A point from which or to which a path goes, as the path gives it: itself, not what is left of it
/// after a way through planar frames; on an edge by the halfedge that the path names.
SurfacePoint endOfPath(const Unfolding& unfolding, const SurfacePoint& point);

/// Whether two points are one, up to kTouch. Points on edges must be given by the same halfedge.
bool samePoint(const SurfacePoint& a, const SurfacePoint& b);

/// A point of a face, given in the frame of one of its halfedges, as a surface point; snapped to an
/// edge or corner within kTouch.
SurfacePoint surfacePointAt(const Unfolding& unfolding, Index halfedge, Vec2 point);

}  // namespace girth::geodesic
