// A changed mesh as a surface of its own.
#pragma once

#include <functional>

#include "girth/remesh.h"
#include "mesh/nearest_point.h"
#include "mesh/remesh/changing_mesh.h"

namespace girth::remeshing {

/// The surface that is left, its vertices in the order that they have, with the place of each on
/// the original, by `placeOf`.
Result<RemeshedSurface> resultOf(const ChangingMesh& mesh,
                                 const std::function<SurfacePoint(Index)>& placeOf);

/// The point of the original nearest to a vertex among the faces that face as it does, or, where
/// there is none, of all. `hint`: a face to look at first.
NearestSearch::Found nearestFacing(const NearestSearch& original,
                                   const std::vector<Vec3>& faceNormals, const ChangingMesh& mesh,
                                   Index vertex, Index hint = kNoIndex);

}  // namespace girth::remeshing
