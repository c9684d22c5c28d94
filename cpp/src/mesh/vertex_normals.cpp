#include "mesh/vertex_normals.h"

#include <array>
#include <utility>

namespace girth {

namespace {

std::array<Vec3, 3> cornersOf(const SurfaceMesh& mesh, Face face) {
  const auto [a, b, c] = mesh.faceVertices(face);
  return {mesh.position(a), mesh.position(b), mesh.position(c)};
}

}  // namespace

std::vector<Vec3> normalsOfFaces(const SurfaceMesh& mesh) {
  std::vector<Vec3> normals(mesh.faceCount());
  for (const Face f : mesh.faces()) {
    const auto [a, b, c] = cornersOf(mesh, f);
    // From unit sides: their product neither overflows nor vanishes.
    const Vec3 u = 1 / mesh.length(SurfaceMesh::side(f, 0)) * (b - a),
               v = 1 / mesh.length(SurfaceMesh::side(f, 2)) * (c - a);
    const Vec3 n = cross(u, v);
    normals[f] = 1 / norm(n) * n;
  }
  return normals;
}

std::vector<Vec3> normalsOfVertices(const SurfaceMesh& mesh) {
  const std::vector<Vec3> ofFaces = normalsOfFaces(mesh);
  std::vector<Vec3> normals(mesh.vertexCount());
  for (const Halfedge h : mesh.halfedges()) {
    Vec3& normal = normals[mesh.from(h)];
    normal = normal + mesh.cornerAngle(h) * ofFaces[h / 3];
  }
  return normals;
}

NearestSearch searchOf(const SurfaceMesh& mesh) {
  std::vector<std::array<Vec3, 3>> triangles(mesh.faceCount());
  for (const Face f : mesh.faces()) triangles[f] = cornersOf(mesh, f);
  return NearestSearch(std::move(triangles));
}

}  // namespace girth
