#include "loops/cut/faces_of_points.h"

#include <algorithm>
#include <cmath>

namespace girth::loops {
namespace {

/// The faces that a point lies in, two at most but at vertices.
template <class Visit>
void forEachFaceAt(const SurfaceMesh& mesh, const SurfacePoint& point, Visit visit) {
  if (point.kind == SurfacePoint::Kind::InFace) {
    visit(point.face());
  } else if (point.kind == SurfacePoint::Kind::OnEdge) {
    visit(SurfaceMesh::faceOf(point.halfedge()));
    const Halfedge twin = mesh.twin(point.halfedge());
    if (twin != Halfedge::none) visit(SurfaceMesh::faceOf(twin));
  } else {
    const Halfedge start = mesh.outgoing(point.vertex());
    for (Halfedge h = start;;) {
      visit(SurfaceMesh::faceOf(h));
      h = mesh.twin(SurfaceMesh::previous(h));
      if (h == Halfedge::none || h == start) return;
    }
  }
}

}  // namespace

bool isPointOf(const SurfaceMesh& mesh, const SurfacePoint& point) {
  const Index count = point.kind == SurfacePoint::Kind::AtVertex ? mesh.vertexCount()
                      : point.kind == SurfacePoint::Kind::OnEdge ? mesh.halfedgeCount()
                                                                 : mesh.faceCount();
  if (point.element >= count) return false;
  double sum = 0;
  for (const double weight : point.weights) {
    if (!(weight >= 0) || !(weight <= 1)) return false;
    sum += weight;
  }
  return std::fabs(sum - 1) < 1e-6;
}

Halfedge edgeOf(const SurfaceMesh& mesh, Halfedge h) {
  const Halfedge twin = mesh.twin(h);
  return twin == Halfedge::none ? h : std::min(h, twin);
}

Face faceAt(const SurfaceMesh& mesh, const SurfacePoint& point) {
  switch (point.kind) {
    case SurfacePoint::Kind::AtVertex:
      return SurfaceMesh::faceOf(mesh.outgoing(point.vertex()));
    case SurfacePoint::Kind::OnEdge:
      return SurfaceMesh::faceOf(point.halfedge());
    case SurfacePoint::Kind::InFace:
      break;
  }
  return point.face();
}

std::optional<Weights> weightsIn(const SurfaceMesh& mesh, Face face, const SurfacePoint& point) {
  Weights weights{};
  for (Index k = 0; k < 3; ++k) {
    const Halfedge side = SurfaceMesh::side(face, k);
    switch (point.kind) {
      case SurfacePoint::Kind::AtVertex:
        if (mesh.from(side) != point.vertex()) continue;
        weights[k] = 1;
        return weights;
      case SurfacePoint::Kind::OnEdge:
        if (edgeOf(mesh, side) != edgeOf(mesh, point.halfedge())) continue;
        weights[k] = side == point.halfedge() ? point.weights[0] : point.weights[1];
        weights[(k + 1) % 3] = side == point.halfedge() ? point.weights[1] : point.weights[0];
        return weights;
      case SurfacePoint::Kind::InFace:
        if (face != point.face()) return std::nullopt;
        return point.weights;
    }
  }
  return std::nullopt;
}

SurfacePoint pointIn(Face face, const Weights& weights) {
  for (Index k = 0; k < 3; ++k) {
    if (weights[k] != 0) continue;
    return SurfacePoint::onHalfedge(SurfaceMesh::side(face, (k + 1) % 3), weights[(k + 2) % 3]);
  }
  return SurfacePoint::inFace(face, weights);
}

SurfacePoint pointBetween(const SurfaceMesh& mesh, Face face, const SurfacePoint& from,
                          const SurfacePoint& to, double share) {
  const Weights a = *weightsIn(mesh, face, from), b = *weightsIn(mesh, face, to);
  Weights weights{};
  for (std::size_t k = 0; k < 3; ++k) weights[k] = (1 - share) * a[k] + share * b[k];
  return pointIn(face, weights);
}

std::optional<CommonFace> commonFace(const SurfaceMesh& mesh, const SurfacePoint& a,
                                     const SurfacePoint& b) {
  std::optional<CommonFace> common;
  const auto visit = [&](Face face) {
    const auto at = weightsIn(mesh, face, a), to = weightsIn(mesh, face, b);
    if (common || !at || !to) return;
    bool isAlongSide = false;
    for (std::size_t k = 0; k < 3; ++k) {
      isAlongSide = isAlongSide || ((*at)[k] == 0 && (*to)[k] == 0);
    }
    common = CommonFace{face, isAlongSide};
  };
  // From the point that lies in fewer faces.
  forEachFaceAt(mesh, a.kind == SurfacePoint::Kind::AtVertex ? b : a, visit);
  return common;
}

}  // namespace girth::loops
