// Which bases of loops are neighbours, and how far they are apart.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth {

/// A neighbour of a base.
struct Neighbour {
  Index base;       ///< its number
  double distance;  ///< along the edge between the two, in model units
};

/// The graph of the edges of a mesh whose vertices have other numbers.
class BaseGraph {
 public:
  BaseGraph() = default;
  /// `baseOf`: the number of each vertex of the mesh; each is there once.
  BaseGraph(const SurfaceMesh& mesh, std::span<const Index> baseOf) {
    first_.assign(baseOf.size() + 1, 0);
    const auto eachEdge = [&](auto&& visit) {
      for (const Halfedge h : mesh.halfedges()) {
        const Halfedge twin = mesh.twin(h);
        if (twin != Halfedge::none && twin < h) continue;
        visit(baseOf[mesh.from(h)], baseOf[mesh.to(h)], mesh.length(h));
      }
    };
    eachEdge([&](Index a, Index b, double) {
      ++first_[a + 1];
      ++first_[b + 1];
    });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    neighbours_.resize(first_.back());
    std::vector<Index> end(first_.begin(), first_.end() - 1);
    eachEdge([&](Index a, Index b, double length) {
      neighbours_[end[a]++] = {b, length};
      neighbours_[end[b]++] = {a, length};
    });
  }

  std::span<const Neighbour> neighbours(Index base) const {
    return {neighbours_.data() + first_[base], first_[base + 1] - first_[base]};
  }

 private:
  std::vector<Index> first_;  // first neighbour of each base, and the end
  std::vector<Neighbour> neighbours_;
};

}  // namespace girth
