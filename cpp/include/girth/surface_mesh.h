// An oriented, manifold triangle mesh: the polyhedral surface that everything is computed on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "girth/elements.h"
#include "girth/error.h"
#include "girth/export.h"
#include "girth/version.h"

namespace girth {

/// A point or direction in space, in model units.
struct Vec3 {
  double x{0};  ///< along the first axis
  double y{0};  ///< along the second axis
  double z{0};  ///< along the third axis
};

/// The treatment of edges that have a face on one side only.
enum class OpenEdges : std::uint8_t {
  Refuse,    ///< OPEN_EDGE: only closed surfaces are wanted
  Boundary,  ///< paths may run along them but not across (web/docs/definitions.md, section 2)
  Wall GIRTH_DEPRECATED("use Boundary") = Boundary,  ///< the older name of Boundary, until 2.0
};

/// The surface: flat triangles, curved only at its vertices (web/docs/definitions.md,
/// section 1: a polyhedral surface).
///
/// Halfedge h = 3 f + k runs along side k of face f, from corner k to corner k+1, with the face on
/// its left. Immutable once made, and so safe to share between threads.
class GIRTH_EXPORT SurfaceMesh {
 public:
  /// Makes a surface from `positions` (x, y, z per vertex) and `triangles` (three vertices per
  /// face, counter-clockwise seen from outside). Vertices and faces keep their numbers. O(n log n).
  /// Open edges are refused or become boundaries.
  ///
  /// Errors, each naming the first offending element: EMPTY_MESH, NON_FINITE_POSITION (vertex),
  /// INDEX_OUT_OF_RANGE (face), DEGENERATE_FACE (face: a repeated vertex, or no area),
  /// OPEN_EDGE, NON_MANIFOLD_EDGE, INCONSISTENT_ORIENTATION (a halfedge of the edge),
  /// NON_MANIFOLD_VERTEX, UNREFERENCED_VERTEX (vertex), LIMIT_EXCEEDED (too many faces to number; a
  /// vertex with a coordinate of more than 1e300).
  ///
  /// \code
  /// const std::vector<double> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  /// const std::vector<girth::Index> triangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  /// const auto tetrahedron = girth::SurfaceMesh::fromArrays(positions, triangles).value();
  /// std::cout << tetrahedron.area() << '\n';
  /// \endcode
  static Result<SurfaceMesh> fromArrays(std::span<const double> positions,
                                        std::span<const Index> triangles,
                                        OpenEdges openEdges = OpenEdges::Refuse);

  /// How many vertices there are.
  Index vertexCount() const { return static_cast<Index>(positions_.size()); }
  /// How many faces there are.
  Index faceCount() const { return static_cast<Index>(from_.size() / 3); }
  /// How many halfedges there are: three for each face.
  Index halfedgeCount() const { return static_cast<Index>(from_.size()); }
  /// How many edges there are; one along a boundary has one halfedge, all others have two.
  Index edgeCount() const { return edgeCount_; }

  /// All vertices, to go through: `for (const Vertex v : mesh.vertices())`.
  ElementRange<VertexKind> vertices() const { return ElementRange<VertexKind>(vertexCount()); }
  /// All faces, to go through.
  ElementRange<FaceKind> faces() const { return ElementRange<FaceKind>(faceCount()); }
  /// All halfedges, to go through.
  ElementRange<HalfedgeKind> halfedges() const {
    return ElementRange<HalfedgeKind>(halfedgeCount());
  }

  /// Where a vertex is, in model units.
  const Vec3& position(Vertex vertex) const { return positions_[vertex]; }
  /// The corners of a face, counter-clockwise seen from outside.
  std::array<Vertex, 3> faceVertices(Face face) const {
    return {Vertex(from_[3 * face]), Vertex(from_[3 * face + 1]), Vertex(from_[3 * face + 2])};
  }

  /// Side k (0, 1 or 2) of a face: the halfedge from corner k to the next one.
  static Halfedge side(Face face, Index k) { return Halfedge(3 * face + k); }
  /// The face that a halfedge is a side of.
  static Face faceOf(Halfedge halfedge) { return Face(halfedge / 3); }
  /// The next side of the same face. (Whether 3 divides a number is found without a division.)
  static Halfedge next(Halfedge halfedge) {
    return Halfedge((halfedge + 1) % 3 == 0 ? halfedge - 2 : halfedge + 1);
  }
  /// The side before, of the same face.
  static Halfedge previous(Halfedge halfedge) {
    return Halfedge(halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1);
  }
  /// The vertex that a halfedge starts from.
  Vertex from(Halfedge halfedge) const { return Vertex(from_[halfedge]); }
  /// The vertex that a halfedge runs to.
  Vertex to(Halfedge halfedge) const { return Vertex(from_[next(halfedge)]); }
  /// The other halfedge of the same edge, in the neighbouring face, running the other way;
  /// Halfedge::none at a boundary.
  Halfedge twin(Halfedge halfedge) const { return Halfedge(twin_[halfedge]); }
  /// One halfedge that starts from a vertex; `twin(previous(h))` is the next one counter-clockwise.
  /// At a boundary vertex it is the first: the one along the boundary.
  Halfedge outgoing(Vertex vertex) const { return Halfedge(outgoing_[vertex]); }
  /// Whether a vertex lies on a boundary.
  bool isBoundary(Vertex vertex) const { return twin_[outgoing_[vertex]] == kNoIndex; }

  /// Length of an edge, in model units.
  double length(Halfedge halfedge) const { return length_[halfedge]; }
  /// Inner angle of a face at the corner that a halfedge starts from, in radians, in (0, π).
  double cornerAngle(Halfedge halfedge) const { return cornerAngle_[halfedge]; }
  /// Total angle Θ of a vertex, in radians: below 2π convex, 2π flat, above 2π saddle
  /// (web/docs/definitions.md, section 1). At a boundary, the angle inside the surface, and π in
  /// the place of 2π.
  double totalAngle(Vertex vertex) const { return totalAngle_[vertex]; }

  /// Area of a face, in squared model units.
  double area(Face face) const;
  /// Area of the whole surface, in squared model units.
  double area() const { return area_; }
  /// Mean length of the edges, in model units.
  double meanEdgeLength() const { return meanEdgeLength_; }

  /// Connected components, numbered in the order of their first vertex.
  Index componentCount() const { return static_cast<Index>(componentGenus_.size()); }
  /// The number of the component that a vertex belongs to.
  Index componentOf(Vertex vertex) const { return component_[vertex]; }
  /// Genus of a component: the number of its handles.
  Index genus(Index component) const { return componentGenus_[component]; }
  /// How many boundary curves a component has.
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
