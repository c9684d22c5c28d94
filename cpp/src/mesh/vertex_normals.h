// Directions in which a surface faces.
#pragma once

#include <vector>

#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "mesh/nearest_point.h"

namespace girth {

/// Unit normals of the faces.
GIRTH_EXPORT std::vector<Vec3> normalsOfFaces(const SurfaceMesh& mesh);

/// Normals of the vertices, not of unit length: those of their faces, weighted by their angles.
GIRTH_EXPORT std::vector<Vec3> normalsOfVertices(const SurfaceMesh& mesh);

/// All faces, to be searched by their numbers.
NearestSearch searchOf(const SurfaceMesh& mesh);

}  // namespace girth
