#include "girth/surface_point.h"

#include "mesh/vector.h"

namespace girth {

Vec3 positionOf(const SurfaceMesh& mesh, const SurfacePoint& point) {
  const auto& w = point.weights;
  switch (point.kind) {
    case SurfacePoint::Kind::Vertex:
      return mesh.position(point.element);
    case SurfacePoint::Kind::Edge:
      return w[0] * mesh.position(mesh.from(point.element)) +
             w[1] * mesh.position(mesh.to(point.element));
    case SurfacePoint::Kind::Face:
      break;
  }
  const auto corners = mesh.faceVertices(point.element);
  return w[0] * mesh.position(corners[0]) + w[1] * mesh.position(corners[1]) +
         w[2] * mesh.position(corners[2]);
}

}  // namespace girth
