// The closed curves of a component up to deformation, and what they are linked with.
//
// A spanning tree of the edges and one of the faces that crosses none of it leave 2g edges. Each
// closes a curve along edges, over the first tree, and is crossed by a curve through faces, over
// the second; the k-th of the ones crosses the k-th of the others once, and none else (tree-cotree
// decomposition: Eppstein 2003, "Dynamic generators of topologically embedded graphs"). So how
// often a curve crosses the curves through faces says what it is made of.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/surface_mesh.h"
#include "loops/tight/taut_loop.h"

namespace girth::loops {

/// A curve as a sum of the 2g basis curves.
using HomologyClass = std::vector<std::int64_t>;
/// Numbers in rows.
using IntegerMatrix = std::vector<HomologyClass>;
/// A row times a square matrix.
HomologyClass product(const HomologyClass& row, const IntegerMatrix& matrix);

/// A surface whose boundary curves are closed, each with a cone over the mean of its corners.
/// Vertices, faces and halfedges of the surface keep their numbers; those of the cones come behind.
struct ClosedSurface {
  explicit ClosedSurface(const SurfaceMesh& mesh);

  Index vertexCount() const { return static_cast<Index>(places.size()); }
  /// Whether a halfedge lies along an edge of the surface itself.
  bool isOwn(Index halfedge) const {
    return faceOfSide(halfedge) < ownFaces || faceOfSide(twins[halfedge]) < ownFaces;
  }

  std::vector<Vec3> places;
  std::vector<Index> from, twins;  ///< by halfedge
  Index ownVertices, ownFaces;
};

/// The classes of closed curves on one component.
class Homology {
 public:
  /// O(n).
  Homology(const SurfaceMesh& mesh, const ClosedSurface& closed, Index component);

  /// 2g.
  std::size_t rank() const { return closing_.size(); }

  /// The basis curve number k along edges of the surface, from one vertex, the same for all, round
  /// to it.
  std::vector<SurfacePoint> basisCurve(std::size_t k) const;

  /// The class of a closed curve: which loops of the basis it is made of. O(its length).
  HomologyClass classOf(const Unfolding& unfolding, const TautLoop& loop) const;

  /// The matrix P of linking numbers: P(i, k) is that of basis curve i and of the k-th curve
  /// through faces, moved off the surface to its outside. If the surface does not cross itself, a
  /// class c has c·P = 0 where its curves bound inside, c·P = c where they bound outside, and P
  /// projects onto these along those (web/docs/definitions.md, section 5). Nothing where the
  /// numbers contradict this. O(e f) for e edges and f faces on the curves. Error: CANCELLED.
  Result<std::optional<IntegerMatrix>> linking(const ExecutionContext& context) const;

 private:
  void growEdgeTree(Index root);
  void growFaceTree();
  /// Halfedges from the vertex where the ways from the root part, round to it.
  std::vector<Index> edgesOf(std::size_t k) const;
  /// The crossings of cycle k among faces: each halfedge is crossed from its own face to that of
  /// its twin.
  std::vector<Index> crossingsOf(std::size_t k) const;
  double linkOf(Index edge, Index crossing) const;
  double outerAngle(Index halfedge) const;
  Vec3 middleOfFace(Index face) const;
  Vec3 areaVector(Index face) const;

  const ClosedSurface* closed_;
  std::vector<Index> vertices_,
      faces_;  // vertices and faces of the component, in the order of the trees
  std::vector<Index> toVertex_, toFace_;  // the halfedge that leads from the parent; kNoIndex
  std::vector<Index> vertexDepth_, faceDepth_;
  std::vector<bool> inTree_;    // halfedges
  std::vector<Index> closing_;  // the 2g halfedges
  struct Share {
    std::size_t curve;
    int sign;
  };
  /// By the ends of a directed edge: how curves through faces cross it.
  std::unordered_map<std::uint64_t, std::vector<Share>> crossed_;
};

}  // namespace girth::loops
