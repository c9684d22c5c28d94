// Conditions that every returned loop must satisfy, checked in space and by angles, apart from the
// solver.
#pragma once

#include "girth/girth_solver.h"

namespace girth::test {

/// The polyline's length is I(p); it starts and ends at p and turns nowhere else (but at the far
/// end of an antipodal one); the midpoint lies on it, half-way.
void expectGeodesicLoop(const SurfaceMesh& mesh, const GirthLoop& loop);

}  // namespace girth::test
