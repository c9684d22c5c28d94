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

/// A handle or tunnel that was taken away.
struct RemovedHandle {
  HandleKind kind{HandleKind::Handle};  ///< which of the two it was
  double length{0};                     ///< the length of its loop, in model units
  Vec3 centre;                          ///< mean of the loop's points, in model units
  /// Area of its tube, which was dropped, in squared model units; 0 where the surface was cut along
  /// the loop and closed.
  double droppedArea{0};
};

/// A surface with fewer handles, and the account of what was done.
struct HandleRemoval {
  SurfaceMesh mesh;  ///< with numbers of its own
  /// Loops that were cut along, in the order of the cuts: points of the surface as it was then.
  /// Each is the shortest round its handle, where `mayBeShorterBy` is 0, as in findHandles.
  std::vector<Handle> removed;
  /// For each of them the area of its tube, which was dropped, in squared model units; 0 where the
  /// surface was cut along the loop and closed.
  std::vector<double> droppedAreas;
  Index genusBefore{0};  ///< genus of all components together
  Index genusAfter{0};   ///< genus of the surface that is left
  /// Faces that were made or moved and cross others, since there was no room for them; those of the
  /// surface that crossed each other before do not count.
  Index crossingFaces{0};
  /// No loop is left that is shorter than this, in model units, but those that touch the boundary:
  /// the length that was asked for, or less where the budget did not suffice to prove it.
  double provenLength{0};

  /// The removed handles without their loops, in the order of the cuts.
  GIRTH_EXPORT std::vector<RemovedHandle> account() const;
};

/// Takes away every handle and tunnel with a loop shorter than a length. A small one loses its
/// tube, the piece of surface round which its loop runs: the surface is cut at both ends of the
/// tube, the tube is dropped, and the ends are closed. No stub is left of a handle, and a tunnel is
/// filled. An end is where curves at equal distance from the loop double their length within half
/// the loop's length: the tube meets the surface that it stands on. Small is a tube of at most 1/10
/// of the area of its component. Round a larger one the surface is cut along the loop. A handle
/// then ends in two stubs, and a tunnel gets a film of material between its ends.
///
/// Every rim is closed with the triangulation of least area. It is drawn back from the cut by a
/// quarter of the way to its neighbours, so that its two sides do not touch. Away from the cuts no
/// vertex is moved.
///
/// Where triangles would lose their area, or a cap, or a face beside it, would cross another face,
/// which is decided exactly, the rim is closed by the first of these that does not: drawn back by
/// 1/16 of the way, by 1/64, not at all; then again by 1/4, 1/16, 1/64 and not at all, with the
/// triangulation of least area among those whose triangles cross no other face (caps of up to 100
/// edges). Where none leaves room, as for a film over a hole that something passes through, it is
/// closed as at first, and the crossing faces are counted.
///
/// Where a handle and a tunnel are one (a small ring stuck to the surface has both loops), the
/// shorter loop is cut, which takes both away. In rounds: all short loops that lie apart from each
/// other, the shortest first; then the surface is searched again, until it is proven that no loop
/// is shorter, as far as the budget of `options` goes (`provenLength`). The number of components
/// stays what it was. Boundary curves are left alone, and so are loops that touch one.
///
/// `length`: in model units, 0 (nothing is removed) or more; infinite: all. Time: findHandles for
/// each round. Errors: INVALID_OPTION (`length` negative or NaN; `basePoints` 0); CANCELLED; those
/// of cutSurface.
GIRTH_EXPORT Result<HandleRemoval> removeHandles(const SurfaceMesh& mesh, double length,
                                                 const HandleOptions& options = {},
                                                 const ExecutionContext& context = {});

}  // namespace girth
