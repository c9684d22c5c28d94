// The vertices and edges around a vertex.
#pragma once

#include "girth/surface_mesh.h"

namespace girth {

/// Calls `visit(halfedge, neighbour)` for each edge of a vertex, counter-clockwise: its halfedge
/// that starts at the vertex, or, for the last edge before a boundary, the one that ends there.
template <class Visit>
void forEachEdge(const SurfaceMesh& mesh, Vertex vertex, Visit visit) {
  const Halfedge start = mesh.outgoing(vertex);
  for (Halfedge h = start;;) {
    visit(h, mesh.to(h));
    const Halfedge back = SurfaceMesh::previous(h);
    h = mesh.twin(back);
    if (h == Halfedge::none) {
      visit(back, mesh.from(back));
      return;
    }
    if (h == start) return;
  }
}

/// Calls `visit(neighbour)` for each neighbour of a vertex, once.
template <class Visit>
void forEachNeighbour(const SurfaceMesh& mesh, Vertex vertex, Visit visit) {
  forEachEdge(mesh, vertex, [&](Halfedge, Vertex neighbour) { visit(neighbour); });
}

}  // namespace girth
