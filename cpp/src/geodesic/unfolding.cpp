#include "geodesic/unfolding.h"

#include <array>

#include "mesh/space_filling_curve.h"
#include "mesh/vector.h"

namespace girth::geodesic {

namespace {

/// The numbers `order` gives new places; this has the new place of each.
std::vector<Index> inverse(const std::vector<Index>& order) {
  std::vector<Index> place(order.size());
  for (Index i = 0; i < order.size(); ++i) place[order[i]] = i;
  return place;
}

}  // namespace

Unfolding::Unfolding(const SurfaceMesh& mesh) : mesh_(&mesh) {
  int exponent = 0;
  std::frexp(mesh.meanEdgeLength(), &exponent);
  unit_ = std::ldexp(1.0, exponent);
  meanEdgeLength_ = mesh.meanEdgeLength() / unit_;

  componentEdge_.resize(mesh.componentCount(), 0);
  std::vector<double> edges(mesh.componentCount(), 0);
  for (const Halfedge h : mesh.halfedges()) {
    const Index component = mesh.componentOf(mesh.from(h));
    componentEdge_[component] += mesh.length(h) / unit_;
    ++edges[component];
  }
  for (Index c = 0; c < mesh.componentCount(); ++c) componentEdge_[c] /= edges[c];

  // Coordinates are divided before they are added, so that the largest do not overflow.
  std::vector<Vec3> points(mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) points[v] = (1 / unit_) * mesh.position(v);
  meshVertex_ = alongCurve(points);
  vertexOfMesh_ = inverse(meshVertex_);
  std::vector<Vec3> centres(mesh.faceCount());
  for (const Face f : mesh.faces()) {
    const auto [a, b, c] = mesh.faceVertices(f);
    centres[f] = (1.0 / 3) * (points[a] + points[b] + points[c]);
  }
  meshFace_ = alongCurve(centres);
  faceOfMesh_ = inverse(meshFace_);

  const Index halfedges = mesh.halfedgeCount();
  const auto fromMeshHalfedge = [&](Index h) {
    return h == kNoIndex ? kNoIndex : 3 * faceOfMesh_[h / 3] + h % 3;
  };
  halfedges_.resize(halfedges);
  for (Index h = 0; h < halfedges; ++h) {
    const Halfedge m(3 * meshFace_[h / 3] + h % 3);
    const Vec3& from = mesh.position(mesh.from(m));
    const Vec3 along = (1 / unit_) * (mesh.position(mesh.to(m)) - from);
    const Vec3 toApex = (1 / unit_) * (mesh.position(mesh.from(SurfaceMesh::previous(m))) - from);
    const double length = girth::norm(along);
    const Vec2 apex{girth::dot(along, toApex) / length,
                    girth::norm(girth::cross(along, toApex)) / length};
    halfedges_[h] = {length, (1 / norm(apex)) * apex, vertexOfMesh_[mesh.from(m)],
                     fromMeshHalfedge(mesh.twin(m))};
  }

  direction_.resize(halfedges);
  totalAngle_.resize(mesh.vertexCount());
  passable_.resize(mesh.vertexCount());
  fans_.reserve(halfedges);
  firstOfFan_.reserve(mesh.vertexCount() + std::size_t{1});
  for (const Vertex v : mesh.vertices()) {
    firstOfFan_.push_back(static_cast<Index>(fans_.size()));
    const Index first = fromMeshHalfedge(mesh.outgoing(Vertex(meshVertex_[v])));
    double angle = 0;
    Index h = first;
    do {
      direction_[h] = angle;
      fans_.push_back(h);
      angle += mesh.cornerAngle(Halfedge(3 * meshFace_[h / 3] + h % 3));
      h = turnLeft(h);
    } while (h != kNoIndex && h != first);
    totalAngle_[v] = angle;
    const double flat = boundary(v) ? kPi : 2 * kPi;
    passable_[v] = angle > flat + kSaddleAngle ? 2 : angle >= flat - kFlatAngle ? 1 : 0;
  }
  firstOfFan_.push_back(static_cast<Index>(fans_.size()));
}

Index Unfolding::home(const SurfacePoint& point) const {
  switch (point.kind) {
    case SurfacePoint::Kind::AtVertex:
      return outgoing(point.element);
    case SurfacePoint::Kind::OnEdge:
      return point.element;
    case SurfacePoint::Kind::InFace:
      break;
  }
  return 3 * point.element;
}

std::optional<Vec2> Unfolding::placeIn(Index halfedge, const SurfacePoint& point) const {
  const Index face = faceOfSide(halfedge);
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Crossing c = crossing(h);
    std::optional<Vec2> place;
    switch (point.kind) {
      case SurfacePoint::Kind::AtVertex:
        if (point.element == c.from()) place = Vec2{0, 0};
        break;
      case SurfacePoint::Kind::OnEdge:
        if (point.element == h) place = Vec2{point.weights[1] * c.length(), 0};
        if (point.element == twin(h)) place = Vec2{point.weights[0] * c.length(), 0};
        break;
      case SurfacePoint::Kind::InFace:
        if (point.element == face && h == 3 * face) {
          place = point.weights[1] * Vec2{c.length(), 0} + point.weights[2] * c.apex();
        }
        break;
    }
    if (place) return toFrame(h, halfedge, *place);
  }
  return std::nullopt;
}

SurfacePoint Unfolding::toMesh(const SurfacePoint& point) const {
  SurfacePoint result = point;
  switch (point.kind) {
    case SurfacePoint::Kind::AtVertex:
      result.element = meshVertex_[point.element];
      break;
    case SurfacePoint::Kind::OnEdge: {
      // Points on edges are given by the smaller of the mesh's two halfedges.
      const Index h = 3 * meshFace_[point.element / 3] + point.element % 3;
      const Halfedge t = mesh_->twin(Halfedge(h));
      result.element = h;
      if (t < h) result = SurfacePoint::onHalfedge(t, point.weights[0]);
      break;
    }
    case SurfacePoint::Kind::InFace:
      result.element = meshFace_[point.element];
      break;
  }
  return result;
}

SurfacePoint Unfolding::fromMesh(const SurfacePoint& point) const {
  SurfacePoint result = point;
  switch (point.kind) {
    case SurfacePoint::Kind::AtVertex:
      result.element = vertexOfMesh_[point.element];
      break;
    case SurfacePoint::Kind::OnEdge:
      result.element = 3 * faceOfMesh_[point.element / 3] + point.element % 3;
      break;
    case SurfacePoint::Kind::InFace:
      result.element = faceOfMesh_[point.element];
      break;
  }
  return result;
}

}  // namespace girth::geodesic
