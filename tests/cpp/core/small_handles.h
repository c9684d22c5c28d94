// Repair of topology on surfaces with small handles and tunnels at random places.
#pragma once

#include <cstdint>

#include "girth/surface_mesh.h"

namespace girth::test {

/// The volume that a closed surface encloses.
double volumeOf(const SurfaceMesh& mesh);

/// Makes an isosurface with two small handles and two small tunnels, takes them away, and expects
/// that these four are gone, that nothing crosses, and that all else stayed as it was.
void expectSmallHandlesRemoved(std::uint64_t seed);

}  // namespace girth::test
