// A point of a surface, in terms of the surface's own elements.
#pragma once

#include <array>
#include <cstdint>

#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth {

/// A vertex; a point at share t of a halfedge; or a point inside a face.
struct SurfacePoint {
  /// The element by which a point is given.
  enum class Kind : std::uint8_t {
    AtVertex,  ///< a vertex
    OnEdge,    ///< a share of a halfedge
    InFace,    ///< barycentric coordinates of a face
  };

  /// Which of the three it is.
  Kind kind{Kind::AtVertex};
  /// The number of the vertex, halfedge or face.
  Index element{0};
  /// Edge: {1 − t, t, 0}, t in [0, 1] from the halfedge's start. Face: barycentric coordinates over
  /// `faceVertices(element)`. Vertex: {1, 0, 0}.
  std::array<double, 3> weights{1, 0, 0};

  /// A vertex.
  static SurfacePoint atVertex(Vertex vertex) { return {Kind::AtVertex, vertex, {1, 0, 0}}; }
  /// The point at share `t`, in [0, 1], of a halfedge from its start.
  static SurfacePoint onHalfedge(Halfedge halfedge, double t) {
    return {Kind::OnEdge, halfedge, {1 - t, t, 0}};
  }
  /// The point of a face with these barycentric coordinates.
  static SurfacePoint inFace(Face face, const std::array<double, 3>& weights) {
    return {Kind::InFace, face, weights};
  }

  /// The vertex that the point is; Vertex::none where it is none.
  Vertex vertex() const { return Vertex(kind == Kind::AtVertex ? element : kNoIndex); }
  /// The halfedge that the point lies on; Halfedge::none where it was not given so.
  Halfedge halfedge() const { return Halfedge(kind == Kind::OnEdge ? element : kNoIndex); }
  /// The face that the point lies in; Face::none where it was not given so.
  Face face() const { return Face(kind == Kind::InFace ? element : kNoIndex); }
};

/// Where the point lies in space.
GIRTH_EXPORT Vec3 positionOf(const SurfaceMesh& mesh, const SurfacePoint& point);

}  // namespace girth
