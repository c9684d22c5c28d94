// Approximate geodesic distances by fast marching (Kimmel and Sethian 1998).
//
// Vertices are accepted in the order of their distances; each then offers its neighbours a distance
// through the triangles that it forms with another accepted vertex, as if the front crossed them
// straight. At an obtuse corner the two neighbours see too little of each other: the faces beyond
// are laid flat until a vertex lies inside the corner, which is split there into two acute ones.
#pragma once

#include <queue>
#include <span>
#include <vector>

#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth::geodesic {

/// The triangles through which distances reach each vertex. Immutable: threads may share it.
class GIRTH_EXPORT MarchingStencils {
 public:
  explicit MarchingStencils(const SurfaceMesh& mesh);

  /// A triangle, of the surface or laid out, over the vertex it belongs to.
  struct Stencil {
    Index a, b;               ///< its other corners
    double lengthA, lengthB;  ///< lengths of the sides to them
    double cosine;            ///< cosine of the angle between these sides
  };
  const SurfaceMesh& mesh() const { return *mesh_; }
  /// Numbers of the stencils that a vertex is a corner `a` or `b` of.
  std::span<const Index> usersOf(Index vertex) const {
    return {users_.data() + usersBegin_[vertex], usersBegin_[vertex + 1] - usersBegin_[vertex]};
  }
  const Stencil& stencil(Index number) const { return stencils_[number]; }
  /// The vertex that a stencil belongs to.
  Index vertexOf(Index number) const { return vertexOf_[number]; }

 private:
  void addCorner(Halfedge halfedge);

  const SurfaceMesh* mesh_;
  std::vector<Stencil> stencils_;
  std::vector<Index> vertexOf_, usersBegin_, users_;
};

/// One march at a time; memory is kept between them and cleared in proportion to what was touched.
class GIRTH_EXPORT FastMarching {
 public:
  explicit FastMarching(const MarchingStencils& stencils)
      : stencils_(&stencils),
        distance_(stencils.mesh().vertexCount(), kFar),
        accepted_(stencils.mesh().vertexCount(), false) {}

  /// Accepts vertices outward from the source, in rising order of distance (equal ones by number);
  /// `visit(vertex, distance)` after each returns whether to go on.
  template <class Visit>
  void run(Index source, Visit visit) {
    start(source);
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (accepted_[entry.vertex] || entry.distance > distance_[entry.vertex]) continue;
      accepted_[entry.vertex] = true;
      if (!visit(entry.vertex, entry.distance)) return;
      spread(entry.vertex);
    }
  }

  /// In model units; infinite where the march did not come.
  double distance(Index vertex) const { return distance_[vertex]; }
  bool accepted(Index vertex) const { return accepted_[vertex]; }

 private:
  static constexpr double kFar = __builtin_inf();
  struct Entry {
    double distance;
    Index vertex;
    bool operator<(const Entry& other) const {  // the nearest on top
      return distance != other.distance ? distance > other.distance : vertex > other.vertex;
    }
  };

  void start(Index source);
  void spread(Index vertex);
  void offer(Index vertex, double distance);

  const MarchingStencils* stencils_;
  std::vector<double> distance_;
  std::vector<bool> accepted_;
  std::vector<Index> touched_;
  std::priority_queue<Entry> queue_;
};

}  // namespace girth::geodesic
