// A triangle mesh whose edges are split, collapsed and flipped.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "girth/surface_mesh.h"
#include "mesh/sides.h"
#include "mesh/vector.h"

namespace girth::remeshing {

/// An oriented manifold with boundary, halfedges numbered as in SurfaceMesh. A removed element
/// leaves its number unused. No operation changes the topology of the surface.
class ChangingMesh {
 public:
  explicit ChangingMesh(const SurfaceMesh& mesh);

  static Index next(Index h) { return nextSide(h); }
  static Index previous(Index h) { return previousSide(h); }
  Index from(Index h) const { return from_[h]; }
  Index to(Index h) const { return from_[next(h)]; }
  /// The vertex opposite.
  Index apex(Index h) const { return from_[previous(h)]; }
  Index twin(Index h) const { return twin_[h]; }
  bool isAlive(Index face) const { return from_[3 * face] != kNoIndex; }
  bool isVertexAlive(Index vertex) const { return outgoing_[vertex] != kNoIndex; }
  Index outgoing(Index vertex) const { return outgoing_[vertex]; }

  /// Whether a halfedge is there, and stands for its edge: the one of the two with the lower
  /// number.
  bool isFirstOfEdge(Index h) const {
    return isAlive(h / 3) && (twin_[h] == kNoIndex || h < twin_[h]);
  }

  Index halfedgeCount() const { return static_cast<Index>(from_.size()); }
  Index vertexCount() const { return static_cast<Index>(positions_.size()); }
  /// Faces that are left.
  Index faceCount() const { return faces_; }

  const Vec3& position(Index vertex) const { return positions_[vertex]; }
  void setPosition(Index vertex, const Vec3& position) { positions_[vertex] = position; }
  double length(Index h) const { return norm(positions_[to(h)] - positions_[from(h)]); }
  /// Twice the area of a face, as a vector across it.
  Vec3 areaVector(Index face) const {
    const Vec3& a = positions_[from_[3 * face]];
    return cross(positions_[from_[3 * face + 1]] - a, positions_[from_[3 * face + 2]] - a);
  }

  /// Whether an edge is part of a line that is kept: a boundary or a sharp edge.
  bool isLine(Index h) const { return line_[h] != 0 || twin_[h] == kNoIndex; }
  void setLine(Index h, bool line);

  /// Calls `visit` with every halfedge from a vertex, counter-clockwise. At a boundary the last
  /// neighbour has none: it is `lastNeighbour`.
  template <class Visit>
  void forEachOutgoing(Index vertex, Visit&& visit) const {
    const Index begin = firstOutgoing(vertex);
    for (Index h = begin;;) {
      visit(h);
      h = twin_[previous(h)];
      if (h == kNoIndex || h == begin) return;
    }
  }
  /// Calls `visit` with every neighbour of a vertex, and whether the edge to it is a line.
  template <class Visit>
  void forEachNeighbour(Index vertex, Visit&& visit) const {
    forEachOutgoing(vertex, [&](Index h) {
      visit(to(h), isLine(h));
      const Index back = previous(h);
      if (twin_[back] == kNoIndex) visit(from_[back], true);
    });
  }
  Index valence(Index vertex) const;
  bool isBoundary(Index vertex) const { return twin_[firstOutgoing(vertex)] == kNoIndex; }
  bool areNeighbours(Index a, Index b) const;
  /// How many lines end at a vertex: 0 inside, 2 on a line, otherwise a corner.
  Index linesAt(Index vertex) const;

  /// The component of the original surface that a vertex belongs to.
  Index component(Index vertex) const { return component_[vertex]; }

  /// Whether a vertex can be put onto an edge. On a component of two faces, which share their three
  /// vertices, it would have two edges to the same neighbour.
  bool canSplit(Index h) const { return twin_[h] == kNoIndex || apex(h) != apex(twin_[h]); }
  /// Puts a vertex onto an edge. Only where canSplit.
  Index split(Index h, const Vec3& position);
  /// Whether the two ends of an edge can become one without a change of topology.
  bool canCollapse(Index h) const;
  /// Makes the two ends one, at `position`. Only where canCollapse. Returns the vertex that is
  /// left.
  Index collapse(Index h, const Vec3& position);
  /// Whether the two faces of an edge can be divided the other way.
  bool canFlip(Index h) const;
  void flip(Index h);

 private:
  /// The first halfedge counter-clockwise at a boundary vertex, any other elsewhere.
  Index firstOutgoing(Index vertex) const;
  Index addFace(Index a, Index b, Index c);
  void join(Index h, Index g);

  std::vector<Vec3> positions_;
  std::vector<Index> from_, twin_, outgoing_, component_;
  std::vector<std::uint8_t> line_;
  Index faces_{0};
};

}  // namespace girth::remeshing
