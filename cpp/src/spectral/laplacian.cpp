#include "spectral/laplacian.h"

#include "mesh/sides.h"
#include "mesh/voronoi_share.h"

namespace girth::spectral {

Laplacian cotangentLaplacian(const IntrinsicTriangulation& triangles, Index vertices) {
  Laplacian result;
  result.areas.assign(vertices, 0);
  for (Index h = 0; h < triangles.halfedgeCount(); ++h) {
    const Index twin = triangles.twin(h);
    if ((twin == kNoIndex || h < twin) && triangles.from(h) != triangles.to(h)) {
      double sum = triangles.oppositeCotangent(h);
      if (twin != kNoIndex) sum += triangles.oppositeCotangent(twin);
      result.edges.push_back({triangles.from(h), triangles.to(h), sum / 2});
    }
    // The corner where h starts; the side opposite to it is the next one.
    const double side = triangles.length(h), opposite = triangles.length(nextSide(h)),
                 other = triangles.length(previousSide(h));
    result.areas[triangles.from(h)] += voronoiShare(
        triangles.area(faceOfSide(h)), opposite * opposite, side * side, other * other);
  }
  return result;
}

std::vector<ComponentLaplacian> byComponent(Laplacian laplacian, const SurfaceMesh& mesh) {
  std::vector<ComponentLaplacian> parts(mesh.componentCount());
  std::vector<Index> place(mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) {
    ComponentLaplacian& part = parts[mesh.componentOf(v)];
    place[v] = static_cast<Index>(part.vertices.size());
    part.vertices.push_back(v);
    part.laplacian.areas.push_back(laplacian.areas[v]);
  }
  for (const Laplacian::Edge& edge : laplacian.edges) {
    parts[mesh.componentOf(Vertex(edge.i))].laplacian.edges.push_back(
        {place[edge.i], place[edge.j], edge.weight});
  }
  return parts;
}

}  // namespace girth::spectral
