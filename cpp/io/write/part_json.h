// Measures of a part of a surface, as JSON.
#pragma once

#include "girth/surface_mesh.h"
#include "text/json_text.h"

namespace girth::io {

/// `area`, `volume` (null where it has a boundary), `faces`, `vertices`, `genus` and `boundaries`.
JsonObject partJson(const SurfaceMesh& part);

}  // namespace girth::io
