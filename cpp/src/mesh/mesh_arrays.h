// The arrays that a surface is made of, to make others of it.
#pragma once

#include <vector>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth {

/// Where the vertices are.
GIRTH_EXPORT std::vector<Vec3> positionsOf(const SurfaceMesh& mesh);

/// Three vertices for each face.
GIRTH_EXPORT std::vector<Index> trianglesOf(const SurfaceMesh& mesh);

/// The surface of these positions and triangles, with or without boundary. Errors: those of
/// SurfaceMesh::fromArrays.
GIRTH_EXPORT Result<SurfaceMesh> surfaceOf(const std::vector<Vec3>& positions,
                                           const std::vector<Index>& triangles);

}  // namespace girth
