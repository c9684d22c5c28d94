// Repair of topology: handles and tunnels that are too small to be meant, taken away.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/handles.h"
#include "girth/surface_mesh.h"

namespace girth {

/// A surface with fewer handles, and the account of what was done.
struct HandleRemoval {
  SurfaceMesh mesh;  ///< with numbers of its own
  /// What was cut along, in the order of the cuts: points of the surface as it was then.
  std::vector<Handle> removed;
  Index genusBefore{0};  ///< of all components together
  Index genusAfter{0};   ///< the same
};

/// Takes away every handle and tunnel with a loop shorter than a length: the surface is cut along
/// the loop, and both rims are closed, each with the triangulation of least area. A handle then
/// ends in two stubs; a tunnel is filled, with a film of material between its ends. Each rim is
/// drawn back from the cut by a quarter of the way to its neighbours, so that its two sides do not
/// touch; by less where triangles would lose their area. Away from the cuts no vertex is moved.
///
/// Of a handle and a tunnel that are one (a small ring stuck to the surface has both loops) the
/// shorter loop is cut, which takes both away. In rounds: all short loops that lie apart from each
/// other, the shortest first; then the surface is searched again, until no loop that is found is
/// shorter. Whether a loop exists that was not found depends on `options`, as findHandles says. The
/// number of components stays what it was. Boundary curves are left alone, and so are loops that
/// touch one. Where there is not
/// enough room, the new faces may cross others: nobody looks.
///
/// `length`: in model units, 0 (nothing is removed) or more; infinite: all. Time: findHandles for
/// each round. Errors: INVALID_OPTION (`length` negative or NaN; `basePoints` 0); CANCELLED; those
/// of cutSurface.
GIRTH_EXPORT Result<HandleRemoval> removeHandles(const SurfaceMesh& mesh, double length,
                                                 const HandleOptions& options = {},
                                                 const ExecutionContext& context = {});

}  // namespace girth
