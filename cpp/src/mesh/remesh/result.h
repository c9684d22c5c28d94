// A changed mesh as a surface of its own.
#pragma once

#include <functional>

#include "girth/remesh.h"
#include "mesh/nearest_point.h"
#include "mesh/remesh/cancellation_poll.h"
#include "mesh/remesh/changing_mesh.h"

namespace girth::remeshing {

/// The surface that is left, its vertices in the order that they have, with the place of each on
/// the original, by `placeOf`. Error: CANCELLED.
Result<RemeshedSurface> resultOf(const ChangingMesh& mesh, CancellationPoll& poll,
                                 const std::function<SurfacePoint(Index)>& placeOf);

/// The component that a face belongs to.
inline Index componentOf(const SurfaceMesh& mesh, Index face) {
  return mesh.componentOf(mesh.from(Halfedge(3 * face)));
}

/// The point of the original nearest to a vertex among the faces of its component that face as it
/// does, or, where there is none, of all of that component. `search`: of the original's faces;
/// `hint`: a face to look at first.
NearestSearch::Found nearestFacing(const SurfaceMesh& original, const NearestSearch& search,
                                   const std::vector<Vec3>& faceNormals, const ChangingMesh& mesh,
                                   Index vertex, Index hint = kNoIndex);

}  // namespace girth::remeshing
