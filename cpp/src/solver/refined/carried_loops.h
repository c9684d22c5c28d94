// Loops of a coarse surface, laid on a fine one that lies beside it.
#pragma once

#include <vector>

#include "geodesic/unfolding.h"
#include "girth/error.h"
#include "girth/execution.h"
#include "girth/surface_mesh.h"

namespace girth {

/// Where a loop of the coarse surface runs on the fine one: faces of the unfolding next to it, in
/// rising order, and the vertex next to its base, of the unfolding.
struct CarriedLoop {
  Index vertex{kNoIndex};
  std::vector<Index> faces;
};

/// The girth of a coarse surface, as it helps with the fine one.
struct CarriedGirth {
  std::vector<CarriedLoop> loops;  ///< by their fine vertices, each of which has one
  std::vector<double> lengths;     ///< the girth at the coarse vertices, in model units
};

/// The loops of all vertices of the coarse surface that have one. Their points are set at distances
/// of the fine surface's mean edge; of the faces near each, the nearest that faces the same way.
/// Coarse vertices next to one fine vertex share a loop. Error: CANCELLED.
Result<CarriedGirth> carriedGirth(const SurfaceMesh& coarse, const geodesic::Unfolding& fine,
                                  const ExecutionContext& context);

}  // namespace girth
