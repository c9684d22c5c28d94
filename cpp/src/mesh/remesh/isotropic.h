// Even triangles: isotropic remeshing.
#pragma once

#include "girth/execution.h"
#include "girth/remesh.h"

namespace girth::remeshing {

/// RemeshMethod::Even of remesh.h, for coordinates of ordinary size.
Result<RemeshedSurface> remeshEvenly(const SurfaceMesh& mesh, Index faces,
                                     const ExecutionContext& context);

}  // namespace girth::remeshing
