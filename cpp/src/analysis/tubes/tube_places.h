// Where tubes narrow and widen.
#pragma once

#include <span>
#include <vector>

#include "analysis/tubes/tube_tree.h"
#include "girth/surface_mesh.h"
#include "girth/tubes.h"

namespace girth::tubes {

/// Which ends of a branch are no side of a narrowing or widening: it ends closed there.
struct ClosedEnds {
  bool below{false}, above{false};
};

/// The narrowings and widenings of a branch, by distance; `girth` of each is NaN. `treeBranch`: its
/// number in the tree. `stations`: its own, at rising distances; `median`: of their diameters.
std::vector<TubePlace> findPlaces(const SurfaceMesh& mesh, const TubeTree& tree, Index treeBranch,
                                  std::span<const TubeStation> stations, double median,
                                  ClosedEnds closed, const TubesOptions& options);

}  // namespace girth::tubes
