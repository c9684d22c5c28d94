#include "girth/surface_point.h"

#include "mesh/vector.h"

namespace girth {

Vec3 positionOf(const SurfaceMesh& mesh, const SurfacePoint& point) {
  const auto& w = point.weights;
  switch (point.kind) {
    case SurfacePoint::Kind::AtVertex:
      return mesh.position(point.vertex());
    case SurfacePoint::Kind::OnEdge:
      return w[0] * mesh.position(mesh.from(point.halfedge())) +
             w[1] * mesh.position(mesh.to(point.halfedge()));
    case SurfacePoint::Kind::InFace:
      break;
  }
  const auto corners = mesh.faceVertices(point.face());
  return w[0] * mesh.position(corners[0]) + w[1] * mesh.position(corners[1]) +
         w[2] * mesh.position(corners[2]);
}

}  // namespace girth
