// Triangulations of closed polygons in space.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::prepare {

/// A triangulation of a polygon without new corners.
struct Triangulation {
  /// In squares of the unit of the corners.
  double area{0};
  /// The corners of each triangle, in rising order: they run as the polygon does.
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// The triangulation of least area (Barequet and Sharir 1995) of a closed polygon of three corners
/// or more, of triangles that have an area. `mayJoin(i, j)`: whether two corners i < j that are no
/// neighbours may be joined. `mayUse(i, k, j)`, where given: whether the triangle of three corners
/// in rising order may be used. Nothing where there is none. The corners in the unit of scaleFor
/// (mesh/face_shape.h). O(n^3).
std::optional<Triangulation> leastAreaTriangulation(
    std::span<const Vec3> polygon, const std::function<bool(std::size_t, std::size_t)>& mayJoin,
    const std::function<bool(std::size_t, std::size_t, std::size_t)>& mayUse = {});

}  // namespace girth::prepare
