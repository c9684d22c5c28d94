#include "geodesic/locate.h"

#include <cmath>
#include <string>

namespace girth::geodesic {

Result<SurfacePoint> locate(const Unfolding& unfolding, const SurfacePoint& point) {
  using Kind = SurfacePoint::Kind;
  const SurfaceMesh& mesh = unfolding.mesh();
  const auto absent = [&](ErrorCode code, const char* what, Index count) {
    return makeError(code, point.element,
                     std::string("there is no ") + what + " " + std::to_string(point.element) +
                         " among " + std::to_string(count));
  };
  if (point.kind == Kind::AtVertex) {
    if (point.element >= mesh.vertexCount()) {
      return absent(ErrorCode::VertexOutOfRange, "vertex", mesh.vertexCount());
    }
    return unfolding.fromMesh(point);
  }
  if (point.kind == Kind::OnEdge && point.element >= mesh.halfedgeCount()) {
    return absent(ErrorCode::InvalidPoint, "halfedge", mesh.halfedgeCount());
  }
  if (point.kind == Kind::InFace && point.element >= mesh.faceCount()) {
    return absent(ErrorCode::InvalidPoint, "face", mesh.faceCount());
  }
  double sum = 0;
  bool valid = point.kind != Kind::OnEdge || point.weights[2] == 0;
  for (const double w : point.weights) {
    valid = valid && w >= -1e-6;  // false where w is not a number
    sum += w;
  }
  if (!valid || !(std::fabs(sum - 1) <= 1e-6)) {
    return makeError(ErrorCode::InvalidPoint, point.element,
                     "the weights of the point are not shares that add up to 1");
  }

  std::array<double, 3> w = point.weights;
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
