// Measures of a part of a surface, as JSON.
#pragma once

#include "girth/io/json_text.h"
#include "girth/surface_mesh.h"

namespace girth::io {

/// `area`, `volume` (null where it has a boundary), `faces`, `vertices`, `genus` and `boundaries`.
JsonObject partJson(const SurfaceMesh& part);

}  // namespace girth::io
