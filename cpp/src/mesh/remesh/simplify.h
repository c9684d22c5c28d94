// Fewer triangles that keep the shape: simplification by quadrics.
#pragma once

#include "girth/execution.h"
#include "girth/remesh.h"

namespace girth::remeshing {

/// RemeshMethod::Fitting of remesh.h, for coordinates of ordinary size and no more faces than there
/// are.
Result<RemeshedSurface> simplify(const SurfaceMesh& mesh, Index faces,
                                 const ExecutionContext& context);

}  // namespace girth::remeshing
