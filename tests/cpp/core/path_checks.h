// Conditions that every returned path must satisfy, apart from the solver.
#pragma once

#include "girth/geodesic_solver.h"

namespace girth::test {

/// The path runs from `from` to `to`, from each of its points straight through a face to the next,
/// and is as long as it says; and that is `distance`.
void expectShortestPath(const SurfaceMesh& mesh, const GeodesicPath& path, const SurfacePoint& from,
                        const SurfacePoint& to, double distance);

}  // namespace girth::test
