// From a surface point that a caller names to one that a propagation can start from.
#pragma once

#include "geodesic/unfolding.h"
#include "girth/error.h"
#include "girth/surface_point.h"

namespace girth::geodesic {

/// A point of the surface in the numbers of the unfolding: an edge point where it lies on a side of
/// its face, a vertex where it lies at a corner, within kSnap. Errors: VERTEX_OUT_OF_RANGE,
/// INVALID_POINT (no such halfedge or face; weights that are negative, not numbers, or do not add
/// up to 1 within a millionth).
Result<SurfacePoint> locate(const Unfolding& unfolding, const SurfacePoint& point);

}  // namespace girth::geodesic
