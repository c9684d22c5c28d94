#include "mesh/mesh_arrays.h"

namespace girth {

std::vector<Vec3> positionsOf(const SurfaceMesh& mesh) {
  std::vector<Vec3> positions;
  positions.reserve(mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) positions.push_back(mesh.position(v));
  return positions;
}

std::vector<Index> trianglesOf(const SurfaceMesh& mesh) {
  std::vector<Index> triangles;
  triangles.reserve(mesh.halfedgeCount());
  for (const Halfedge h : mesh.halfedges()) triangles.push_back(mesh.from(h));
  return triangles;
}

Result<SurfaceMesh> surfaceOf(const std::vector<Vec3>& positions,
                              const std::vector<Index>& triangles) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * positions.size());
  for (const Vec3& p : positions) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  return SurfaceMesh::fromArrays(coordinates, triangles, OpenEdges::Boundary);
}

}  // namespace girth
