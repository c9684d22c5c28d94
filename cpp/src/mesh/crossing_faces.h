// Faces of a surface that cross each other.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth {

/// Corners of a triangle in space.
using Triangle3 = std::array<Vec3, 3>;

/// Whether two triangles have a point in common besides corners that they share: `shared` of them,
/// the first of each, in the same order. Exact (mesh/orientation.h). Triangles that share an edge
/// have more in common where one lies folded on the other.
bool trianglesMeet(const Triangle3& a, const Triangle3& b, std::size_t shared);

/// A face by its vertices and where they lie.
struct PlacedFace {
  std::array<Vertex, 3> vertices;
  Triangle3 places;
};

/// Whether two faces meet but in the corners and edges which they share: those that are one vertex.
bool facesMeet(PlacedFace a, PlacedFace b);

/// Pairs of faces that meet but in the corners and edges which they share, at least one of each
/// pair among `faces`; each pair once, the lower number first, in rising order. Corners are the
/// same where they are one vertex, wherever that is. O(n log n + boxes that overlap).
std::vector<std::pair<Face, Face>> crossingFaces(const SurfaceMesh& mesh,
                                                 std::span<const Face> faces);

}  // namespace girth
