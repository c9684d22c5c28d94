// Connected regions of vertices.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "girth/surface_mesh.h"
#include "mesh/neighbours.h"

namespace girth {

/// Divides the vertices into connected regions of one label, by the edges of the surface; regions
/// in the order of their first vertex, each in rising order. Vertices for which `labelOf` gives
/// kNoIndex are left out. O(n log n).
template <class LabelOf>
std::vector<std::vector<Vertex>> connectedRegions(const SurfaceMesh& mesh, LabelOf labelOf) {
  std::vector<std::vector<Vertex>> regions;
  std::vector<bool> taken(mesh.vertexCount(), false);
  for (const Vertex seed : mesh.vertices()) {
    const Index label = labelOf(seed);
    if (taken[seed] || label == kNoIndex) continue;
    std::vector<Vertex> region{seed};
    taken[seed] = true;
    for (std::size_t i = 0; i < region.size(); ++i) {
      forEachNeighbour(mesh, region[i], [&](Vertex neighbour) {
        if (taken[neighbour] || labelOf(neighbour) != label) return;
        taken[neighbour] = true;
        region.push_back(neighbour);
      });
    }
    std::sort(region.begin(), region.end());
    regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace girth
