// Lower bounds on the loops at all vertices, by those at a few.
//
// A loop at one vertex is one at another by the way there and back: so the shortest of a kind
// changes by at most twice the distance.
#pragma once

#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "girth/surface_mesh.h"
#include "mesh/neighbours.h"

namespace girth::loops {

/// Lower bounds of a length at the vertices of a mesh; 0 where nothing is known. The mesh must
/// outlive them.
class LengthBounds {
 public:
  explicit LengthBounds(const SurfaceMesh& mesh) : mesh_(mesh), least_(mesh.vertexCount(), 0) {}

  double at(Vertex vertex) const { return least_[vertex]; }

  /// Takes in what is known at some vertices; the ways are those along edges. O(n log n) at most,
  /// for the n vertices of which more is known than before.
  void raise(std::span<const std::pair<Vertex, double>> known) {
    std::priority_queue<std::pair<double, Index>> queue;
    const auto raiseAt = [&](Vertex vertex, double least) {
      if (!(least > least_[vertex])) return;
      least_[vertex] = least;
      queue.emplace(least, vertex);
    };
    for (const auto& [vertex, least] : known) raiseAt(vertex, least);
    while (!queue.empty()) {
      const double least = queue.top().first;
      const Vertex vertex(queue.top().second);
      queue.pop();
      if (least < least_[vertex]) continue;
      forEachEdge(mesh_, vertex, [&](Halfedge h, Vertex neighbour) {
        raiseAt(neighbour, least - 2 * mesh_.length(h));
      });
    }
  }

 private:
  const SurfaceMesh& mesh_;
  std::vector<double> least_;
};

}  // namespace girth::loops
