// Caps of rims that cross nothing.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/crossing_faces.h"

namespace girth::loops {

/// The closed polygon that faces fill without vertices of their own, in their orientation; empty
/// where they fill several, or one that passes a vertex twice, or have a vertex within.
std::vector<Vertex> polygonOf(std::span<const std::array<Vertex, 3>> faces);

/// The triangulation of least area among those of a polygon whose triangles have an area and meet
/// none of some other faces but in corners and edges that they share; nothing where there is none.
/// `places`: of all vertices. O(n^3) triangles of n corners, each compared with the faces beside
/// it.
std::optional<std::vector<std::array<Vertex, 3>>> clearCap(std::span<const Vertex> polygon,
                                                           std::span<const Vec3> places,
                                                           std::span<const PlacedFace> others);

}  // namespace girth::loops
