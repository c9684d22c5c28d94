#include "geodesic/unfolding.h"

#include "mesh/vector.h"

namespace girth::geodesic {

namespace {

/// The three corners of a face in its own frame, from their places in space, measured in `unit`.
std::array<Vec2, 3> cornersOf(const SurfaceMesh& mesh, Index face, double unit) {
  const auto [a, b, c] = mesh.faceVertices(face);
  const Vec3 ab = (1 / unit) * (mesh.position(b) - mesh.position(a));
  const Vec3 ac = (1 / unit) * (mesh.position(c) - mesh.position(a));
  const double length = girth::norm(ab);
  return {Vec2{0, 0}, Vec2{length, 0},
          Vec2{girth::dot(ab, ac) / length, girth::norm(girth::cross(ab, ac)) / length}};
}

}  // namespace

Unfolding::Unfolding(const SurfaceMesh& mesh) : mesh_(&mesh) {
  int exponent = 0;
  std::frexp(mesh.meanEdgeLength(), &exponent);
  unit_ = std::ldexp(1.0, exponent);
  meanEdgeLength_ = mesh.meanEdgeLength() / unit_;

  sides_.resize(mesh.halfedgeCount());
  for (Index face = 0; face < mesh.faceCount(); ++face) {
    const auto corners = cornersOf(mesh, face, unit_);
    for (Index k = 0; k < 3; ++k) {
      Side& side = sides_[3 * face + k];
      const Vec2 along = corners[(k + 1) % 3] - corners[k];
      side.start = corners[k];
      side.length = norm(along);
      side.direction = (1 / side.length) * along;
      side.twin = mesh.twin(3 * face + k);
      side.from = mesh.from(3 * face + k);
    }
  }
  for (Side& side : sides_) {
    const Side& twin = sides_[side.twin];
    // The motion turns this side's direction into the opposite of the twin's.
    const Vec2 turned = -1 * twin.direction;
    side.rotation = {dot(side.direction, turned), cross(side.direction, turned)};
    side.translation = {0, 0};
    side.translation = twin.at(twin.length) - side.toTwin(side.start);
  }

  direction_.resize(mesh.halfedgeCount());
  passable_.resize(mesh.vertexCount());
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    double angle = 0;
    Index h = mesh.outgoing(v);
    do {
      direction_[h] = angle;
      angle += mesh.cornerAngle(h);
      h = mesh.twin(SurfaceMesh::previous(h));
    } while (h != mesh.outgoing(v));
    passable_[v] = angle > 2 * kPi + kSaddleAngle ? 2 : angle >= 2 * kPi - kFlatAngle ? 1 : 0;
  }
}

}  // namespace girth::geodesic
