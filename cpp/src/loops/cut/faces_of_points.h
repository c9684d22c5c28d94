// Which faces points of a surface lie in, and where in them.
#pragma once

#include <array>
#include <optional>

#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth::loops {

/// Barycentric coordinates in a face.
using Weights = std::array<double, 3>;

/// Whether it is a point of the surface: an element that there is, and weights of at least 0 that
/// add up to 1.
bool isPointOf(const SurfaceMesh& mesh, const SurfacePoint& point);

/// An edge by the lower of its halfedges.
Halfedge edgeOf(const SurfaceMesh& mesh, Halfedge h);

/// One of the faces that a point lies in.
Face faceAt(const SurfaceMesh& mesh, const SurfacePoint& point);

/// The barycentric coordinates of a point in a face; nothing where it does not lie there.
std::optional<Weights> weightsIn(const SurfaceMesh& mesh, Face face, const SurfacePoint& point);

/// The point of a face with these coordinates: on a side where one of them is 0.
SurfacePoint pointIn(Face face, const Weights& weights);

/// The point at a share of the way between two points of a face.
SurfacePoint pointBetween(const SurfaceMesh& mesh, Face face, const SurfacePoint& from,
                          const SurfacePoint& to, double share);

/// A face that two points have in common, and whether both lie on one of its sides.
struct CommonFace {
  Face face;
  bool isAlongSide{false};
};
std::optional<CommonFace> commonFace(const SurfaceMesh& mesh, const SurfacePoint& a,
                                     const SurfacePoint& b);

}  // namespace girth::loops
