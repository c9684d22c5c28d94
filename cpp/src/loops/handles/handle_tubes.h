// Tubes that handles and tunnels of a surface consist of, each between its two ends.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "girth/cut_surface.h"
#include "girth/error.h"
#include "girth/execution.h"
#include "girth/handles.h"
#include "girth/surface_mesh.h"

namespace girth::loops {

/// A tube between two ends on the rest of the surface.
struct HandleTube {
  std::array<SurfaceCurve, 2> ends;  ///< closed curves that cut it off
  Vertex inside;                     ///< a vertex of the tube
  std::set<Index> faces;             ///< all faces that it lies in, in whole or in part
};

/// The faces that a curve runs through or along.
std::set<Index> facesAlong(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points);

/// For each handle its tube; nothing where it has none that is small, and where two tubes, or a
/// tube and another loop, would share a face. `handles`: loops that share no face, off the
/// boundary, the most important one first.
///
/// Curves at equal distance from the loop move away from it to both sides. An end is where such a
/// curve has become twice as long within half the loop's length: the tube has met the surface that
/// it stands on. Small is a tube of at most kLargestTube of the area of its component. O(n) for
/// each handle, besides exact distances on its tube. Errors: those of cutSurface.
Result<std::vector<std::optional<HandleTube>>> findHandleTubes(const SurfaceMesh& mesh,
                                                               std::span<const Handle> handles,
                                                               const ExecutionContext& context);

/// The largest share of its component's area that a tube may have.
inline constexpr double kLargestTube = 0.1;

}  // namespace girth::loops
