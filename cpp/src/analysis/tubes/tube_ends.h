// The ends of tubular surfaces.
#pragma once

#include <span>
#include <vector>

#include "analysis/tubes/tube_tree.h"
#include "girth/error.h"
#include "girth/execution.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth::tubes {

/// The ends of each component without handles, the first end of each before its others; by
/// component. `given`: as TubesOptions::ends. Errors: as growTree.
Result<std::vector<TreeEnd>> findEnds(const SurfaceMesh& mesh, std::span<const SurfacePoint> given,
                                      const ExecutionContext& context);

}  // namespace girth::tubes
