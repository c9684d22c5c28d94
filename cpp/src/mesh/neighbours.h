// The vertices and edges around a vertex.
#pragma once

#include "girth/surface_mesh.h"

namespace girth {

/// Calls `visit(halfedge, neighbour)` for each edge of a vertex, counter-clockwise: its halfedge
/// that starts at the vertex, or, for the last edge before a boundary, the one that ends there.
template <class Visit>
void forEachEdge(const SurfaceMesh& mesh, Index vertex, Visit visit) {
  const Index start = mesh.outgoing(vertex);
  for (Index h = start;;) {
    visit(h, mesh.to(h));
    const Index back = SurfaceMesh::previous(h);
    h = mesh.twin(back);
    if (h == kNoIndex) {
      visit(back, mesh.from(back));
      return;
    }
    if (h == start) return;
  }
}

/// Calls `visit(neighbour)` for each neighbour of a vertex, once.
template <class Visit>
void forEachNeighbour(const SurfaceMesh& mesh, Index vertex, Visit visit) {
  forEachEdge(mesh, vertex, [&](Index, Index neighbour) { visit(neighbour); });
}

}  // namespace girth
