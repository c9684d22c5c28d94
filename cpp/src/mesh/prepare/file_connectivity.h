// Neighbours of faces by the numbers of a file.
#pragma once

#include <span>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::prepare {

/// For each vertex whether the file's own numbers close the surface round it, so that its position
/// does not matter: all edges there have two faces. `place` names for each vertex the first one at
/// its position. Vertices of faces that coincide with others are closed only where all these are of
/// closed components that differ; a component that is there twice, or
/// is two sheets on each other, becomes one. O(n log n).
std::vector<bool> closedByTheFile(std::span<const Index> triangles,
                                  const std::vector<Index>& place);

}  // namespace girth::prepare
