// Measures of a part of a surface, as JSON.
#pragma once

#include "girth/io/result_json.h"
#include "girth/surface_mesh.h"

namespace girth::io {

/// Its measures, and the numbers of its `faces` and `vertices`.
ResultJson partJson(const SurfaceMesh& part);

}  // namespace girth::io
