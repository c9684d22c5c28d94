// Subdividing: one surface in more triangles.
#pragma once

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/prepare_surface.h"

namespace girth {

/// Cuts triangles in two, always at the longest edge there is, until there are `faces` of them, or
/// one more. The surface stays where it is, but for the rounding of midpoints; so its girth does
/// too. The vertices keep their numbers, and new ones follow that come from none of the input.
/// Faces keep the triangle of the input that they cover. A surface that has as many stays as it is.
/// No angle becomes smaller than half the smallest one there was (Rosenberg and Stenger 1975). O(n
/// log n) in the faces that come out.
///
/// Errors: those of SurfaceMesh::fromArrays, where edges become too short for doubles; CANCELLED.
GIRTH_EXPORT Result<PreparedSurface> subdivideSurface(PreparedSurface surface, Index faces,
                                                      const ExecutionContext& context = {});

}  // namespace girth
