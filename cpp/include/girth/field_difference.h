// How far the values of two surfaces are from each other as distributions.
#pragma once

#include <span>

#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth {

/// Equation (1) of the paper: the integral of |CDF1 − CDF2| over the values, for fields at the
/// vertices of two surfaces. Each distribution counts vertices by their Voronoi areas
/// (vertex_areas.h); each field is divided by the root of its surface's area, so that size does not
/// matter. Vertices without a value (NaN) do not count; without any, the result is NaN. O(n log n).
GIRTH_EXPORT double fieldDifference(const SurfaceMesh& mesh1, std::span<const double> values1,
                                    const SurfaceMesh& mesh2, std::span<const double> values2);

}  // namespace girth
