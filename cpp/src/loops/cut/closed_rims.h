// Rims of a cut surface drawn back and closed, so that nothing crosses where there is room.
#pragma once

#include "girth/cut_surface.h"
#include "girth/error.h"
#include "girth/execution.h"
#include "girth/surface_mesh.h"

namespace girth::loops {

/// A surface whose cuts are closed.
struct ClosedRims {
  SurfaceMesh mesh;
  Index crossingFaces{0};  ///< faces that there was no room for
};

/// Closes every rim by the first way in which triangles keep their area and cross nothing
/// (girth/remove_handles.h). `cut`: with caps. Error: that of SurfaceMesh::fromArrays; CANCELLED.
Result<ClosedRims> closedRims(const CutSurface& cut, const ExecutionContext& context);

}  // namespace girth::loops
