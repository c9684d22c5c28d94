// Where tubes narrow and widen.
#pragma once

#include <span>
#include <vector>

#include "analysis/tubes/tube_tree.h"
#include "girth/surface_mesh.h"
#include "girth/tubes.h"

namespace girth::tubes {

/// The narrowings and widenings of a branch, by distance; `girth` of each is NaN. `treeBranch`: its
/// number in the tree. `stations`: its own, at rising distances; `median`: of their diameters. A
/// cap of a closed end is no side of a place.
std::vector<TubePlace> findPlaces(const SurfaceMesh& mesh, const TubeTree& tree, Index treeBranch,
                                  std::span<const TubeStation> stations, double median,
                                  const TubesOptions& options);

}  // namespace girth::tubes
