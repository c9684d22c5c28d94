// A surface without the wrinkles of a rough scan: the same triangles, vertices moved.
#pragma once

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth {

/// The most steps of smoothing.
inline constexpr Index kMostSmoothing = 100;

/// Each step moves every vertex towards the mean of its neighbours, by half of the way, and then
/// away from their new mean, by 0.53 of the way (Taubin 1995, "A signal processing approach to fair
/// surface design", section 3). Wrinkles about as long as an edge go, and limbs stay as thick as
/// they are. A vertex of a boundary goes by its two neighbours there, so that boundaries keep to
/// themselves. Three steps do for noise of half an edge. Vertices and faces keep their numbers.
/// Faces may come to intersect. `steps`: from 0, which is the surface itself. O(steps · n).
///
/// Errors: INVALID_OPTION (steps); DEGENERATE_FACE where a face loses its area; CANCELLED.
///
/// \code
/// const girth::SurfaceMesh smooth = girth::smoothSurface(mesh, 3).value();
/// std::cout << smooth.area() / mesh.area() << '\n';
/// \endcode
GIRTH_EXPORT Result<SurfaceMesh> smoothSurface(const SurfaceMesh& mesh, Index steps,
                                               const ExecutionContext& context = {});

}  // namespace girth
