// Level curves of a function: where it has one value.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <span>
#include <vector>

#include "girth/cut_surface.h"
#include "girth/error.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth {

/// The curves between the vertices of at least a level and those below it, where the function is
/// linear between the vertices: straight through every face, so that cutSurface can cut along them.
/// Seen from outside, what is below lies on the left. Closed but where they meet the boundary or a
/// vertex without a value (NaN); those at the boundary come first. They touch each other at most at
/// vertices of exactly the level.
///
/// `values`: for each vertex. O(n). Errors: USAGE where they are not as many as the vertices;
/// INVALID_OPTION where the level is not finite.
GIRTH_EXPORT Result<std::vector<SurfaceCurve>> levelCurves(const SurfaceMesh& mesh,
                                                           std::span<const double> values,
                                                           double level);

}  // namespace girth
