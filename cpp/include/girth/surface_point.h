// A point of a surface, said in terms of the surface's own elements.
#pragma once

#include <array>
#include <cstdint>

#include "girth/surface_mesh.h"

namespace girth {

/// A vertex; a point at share t of a halfedge; or a point inside a face.
struct SurfacePoint {
  enum class Kind : std::uint8_t { Vertex, Edge, Face };

  Kind kind{Kind::Vertex};
  /// Vertex, halfedge or face.
  Index element{0};
  /// Edge: {1 − t, t, 0}, t in [0, 1] from the halfedge's start. Face: barycentric coordinates over
  /// `faceVertices(element)`. Vertex: {1, 0, 0}.
  std::array<double, 3> weights{1, 0, 0};

  static SurfacePoint atVertex(Index vertex) { return {Kind::Vertex, vertex, {1, 0, 0}}; }
  static SurfacePoint onHalfedge(Index halfedge, double t) {
    return {Kind::Edge, halfedge, {1 - t, t, 0}};
  }
  static SurfacePoint inFace(Index face, const std::array<double, 3>& weights) {
    return {Kind::Face, face, weights};
  }
};

/// Where the point lies in space.
Vec3 positionOf(const SurfaceMesh& mesh, const SurfacePoint& point);

}  // namespace girth
