#include "geodesic/locate.h"

#include <array>
#include <utility>

#include "mesh/check_point.h"

namespace girth::geodesic {

Result<SurfacePoint> locate(const Unfolding& unfolding, const SurfacePoint& point) {
  using Kind = SurfacePoint::Kind;
  const SurfaceMesh& mesh = unfolding.mesh();
  if (auto error = checkPoint(mesh, point)) return *std::move(error);
  if (point.kind == Kind::AtVertex) return unfolding.fromMesh(point);

  std::array<double, 3> w = point.weights;
  const double sum = w[0] + w[1] + w[2];
  for (double& share : w) share = share < kSnap ? 0 : share / sum;
  // As a point of a side, if it lies on one.
  Index halfedge = point.element;
  double start = w[0], end = w[1];
  if (point.kind == Kind::InFace) {
    Index k = 0;
    while (k < 3 && w[(k + 2) % 3] != 0) ++k;
    if (k == 3) return unfolding.fromMesh(SurfacePoint::inFace(Face(point.element), w));
    halfedge = 3 * point.element + k;
    start = w[k];
    end = w[(k + 1) % 3];
  }
  if (start == 0) return unfolding.fromMesh(SurfacePoint::atVertex(mesh.to(Halfedge(halfedge))));
  if (end == 0) return unfolding.fromMesh(SurfacePoint::atVertex(mesh.from(Halfedge(halfedge))));
  return unfolding.fromMesh(SurfacePoint::onHalfedge(Halfedge(halfedge), end / (start + end)));
}

}  // namespace girth::geodesic
