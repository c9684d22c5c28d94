// An oriented, manifold triangle mesh: the polyhedral surface that everything is computed on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "girth/error.h"

namespace girth {

/// Numbers of vertices, faces and halfedges; all count from 0.
using Index = std::uint32_t;
inline constexpr Index kNoIndex = 0xFFFFFFFFu;

/// A point or direction in space, in model units.
struct Vec3 {
  double x{0}, y{0}, z{0};
};

/// What to do with edges that have a face on one side only.
enum class OpenEdges : std::uint8_t {
  Refuse,    ///< OPEN_EDGE: only closed surfaces are wanted
  Boundary,  ///< paths may run along them but not across (DEFINITIONS section 2)
};

/// The surface: flat triangles, curved only at its vertices (DEFINITIONS: a polyhedral surface).
///
/// Halfedge h = 3 f + k runs along side k of face f, from corner k to corner k+1, with the face on
/// its left. Immutable once made, and so safe to share between threads.
class SurfaceMesh {
 public:
  /// Makes a surface from `positions` (x, y, z per vertex) and `triangles` (three vertices per
  /// face, counter-clockwise seen from outside). Vertices and faces keep their numbers. O(n log n).
  /// Open edges are refused or become boundaries.
  ///
  /// Errors, each naming the first offending element: EMPTY_MESH, NON_FINITE_POSITION (vertex),
  /// INDEX_OUT_OF_RANGE (face), DEGENERATE_FACE (face: a repeated vertex, or no area),
  /// OPEN_EDGE, NON_MANIFOLD_EDGE, INCONSISTENT_ORIENTATION (a halfedge of the edge),
  /// NON_MANIFOLD_VERTEX, UNREFERENCED_VERTEX (vertex), LIMIT_EXCEEDED (too many faces to number).
  static Result<SurfaceMesh> fromArrays(std::span<const double> positions,
                                        std::span<const Index> triangles,
                                        OpenEdges openEdges = OpenEdges::Refuse);

  Index vertexCount() const { return static_cast<Index>(positions_.size()); }
  Index faceCount() const { return static_cast<Index>(from_.size() / 3); }
  Index halfedgeCount() const { return static_cast<Index>(from_.size()); }
  Index edgeCount() const { return edgeCount_; }

  const Vec3& position(Index vertex) const { return positions_[vertex]; }
  std::array<Index, 3> faceVertices(Index face) const {
    return {from_[3 * face], from_[3 * face + 1], from_[3 * face + 2]};
  }

  static Index faceOf(Index halfedge) { return halfedge / 3; }
  /// The other two of a face. (Whether 3 divides a number is told without a division.)
  static Index next(Index halfedge) {
    return (halfedge + 1) % 3 == 0 ? halfedge - 2 : halfedge + 1;
  }
  static Index previous(Index halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }
  /// The vertex that a halfedge starts from, and the one it runs to.
  Index from(Index halfedge) const { return from_[halfedge]; }
  Index to(Index halfedge) const { return from_[next(halfedge)]; }
  /// The other halfedge of the same edge, in the neighbouring face, running the other way; kNoIndex
  /// at a boundary.
  Index twin(Index halfedge) const { return twin_[halfedge]; }
  /// One halfedge that starts from a vertex; `twin(previous(h))` is the next one counter-clockwise.
  /// At a boundary vertex it is the first: the one along the boundary.
  Index outgoing(Index vertex) const { return outgoing_[vertex]; }
  /// Whether a vertex lies on a boundary.
  bool isBoundary(Index vertex) const { return twin_[outgoing_[vertex]] == kNoIndex; }

  /// Length of an edge, in model units.
  double length(Index halfedge) const { return length_[halfedge]; }
  /// Inner angle of a face at the corner that a halfedge starts from, in radians, in (0, π).
  double cornerAngle(Index halfedge) const { return cornerAngle_[halfedge]; }
  /// Total angle Θ of a vertex: below 2π convex, 2π flat, above 2π saddle (DEFINITIONS section 1).
  /// At a boundary, the angle inside the surface, and π in the place of 2π.
  double totalAngle(Index vertex) const { return totalAngle_[vertex]; }

  /// Area of a face, and of the whole surface, in squared model units.
  double area(Index face) const;
  double area() const { return area_; }
  /// Mean length of the edges.
  double meanEdgeLength() const { return meanEdgeLength_; }

  /// Connected components, numbered in the order of their first vertex.
  Index componentCount() const { return static_cast<Index>(componentGenus_.size()); }
  Index componentOf(Index vertex) const { return component_[vertex]; }
  /// Genus of a component: the number of its handles; and of its boundary curves.
  Index genus(Index component) const { return componentGenus_[component]; }
  Index boundaryCount(Index component) const { return componentBoundaries_[component]; }

 private:
  SurfaceMesh() = default;
  std::vector<Vec3> positions_;
  std::vector<Index> from_, twin_, outgoing_, component_, componentGenus_, componentBoundaries_;
  Index edgeCount_{0};
  std::vector<double> length_, cornerAngle_, totalAngle_;
  double area_{0}, meanEdgeLength_{0};
};

}  // namespace girth
