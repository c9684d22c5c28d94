// What a part of a surface measures, as members of a JSON object.
#pragma once

#include <string>

#include "girth/surface_mesh.h"

namespace girth::io {

/// `area`, `volume` (null where it has a boundary), `faces`, `vertices`, `genus` and `boundaries`,
/// without braces.
std::string partMembers(const SurfaceMesh& part);

}  // namespace girth::io
