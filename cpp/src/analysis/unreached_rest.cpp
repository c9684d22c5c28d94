#include "analysis/unreached_rest.h"

#include <algorithm>
#include <cmath>

#include "infinity.h"
#include "mesh/neighbours.h"

namespace girth {

namespace {

/// The height at which what stays is reached.
/// Disjoint sets of vertices.
class VertexSets {
 public:
  explicit VertexSets(Index count) : parent_(count, kNoIndex) {}
  void add(Index v) { parent_[v] = v; }
  bool contains(Index v) const { return parent_[v] != kNoIndex; }
  Index find(Index v) {
    while (parent_[v] != v) {
      parent_[v] = parent_[parent_[v]];
      v = parent_[v];
    }
    return v;
  }
  void join(Index part, Index whole) { parent_[part] = whole; }

 private:
  std::vector<Index> parent_;
};

/// A part of the rest between two moments at which it is divided.
struct RestPart {
  Vertex highest;
  bool open{false};          ///< it has boundary vertices
  std::vector<Index> parts;  ///< parts that it falls into, at last
  Vertex split;              ///< the vertex at which it does
};

/// The parts of the rest, from the highest vertex down to the lowest, which makes them one.
class RestParts {
 public:
  RestParts(const SurfaceMesh& mesh, std::span<const double> heights,
            const std::vector<Vertex>& order)
      : heights_(heights), partOf_(mesh.vertexCount(), kNoIndex), met_(mesh.vertexCount(), 0) {
    VertexSets sets(mesh.vertexCount());
    for (auto at = order.rbegin(); at != order.rend(); ++at) {
      const Vertex v = *at;
      std::vector<Index> met;
      forEachNeighbour(mesh, v, [&](Vertex neighbour) {
        if (!sets.contains(neighbour)) return;
        const Index root = sets.find(neighbour);
        if (std::find(met.begin(), met.end(), root) == met.end()) met.push_back(root);
      });
      met_[v] = static_cast<Index>(met.size());
      sets.add(v);
      for (const Index root : met) sets.join(root, v);
      partOf_[v] = met.size() == 1 ? partOf_[met[0]] : begin(v, met);
      parts_[partOf_[v]].open = parts_[partOf_[v]].open || mesh.isBoundary(v);
    }
  }

  /// How many parts of the rest meet at a vertex as it is reached.
  Index met(Vertex v) const { return met_[v]; }
  Index partOf(Vertex v) const { return partOf_[v]; }
  const std::vector<RestPart>& parts() const { return parts_; }

  double depth(Index part, Vertex from) const {
    return parts_[part].open ? kInfinity : heights_[parts_[part].highest] - heights_[from];
  }

 private:
  /// A new part, from a maximum or from several that meet.
  Index begin(Vertex v, const std::vector<Index>& met) {
    RestPart part;
    part.highest = v;
    part.split = v;
    for (const Index root : met) {
      const Index inner = partOf_[root];
      part.parts.push_back(inner);
      part.open = part.open || parts_[inner].open;
      if (heights_[parts_[inner].highest] > heights_[part.highest]) {
        part.highest = parts_[inner].highest;
      }
    }
    // The deepest first: it goes on as the main part.
    std::stable_sort(part.parts.begin(), part.parts.end(),
                     [&](Index a, Index b) { return depth(a, v) > depth(b, v); });
    parts_.push_back(std::move(part));
    return static_cast<Index>(parts_.size() - 1);
  }

  std::span<const double> heights_;
  std::vector<Index> partOf_, met_;
  std::vector<RestPart> parts_;
};

/// How many runs of lower neighbours a vertex inside the surface has, round it.
Index lowerRuns(const SurfaceMesh& mesh, const std::vector<Index>& rank, Vertex v) {
  Index runs = 0;
  bool first = false, before = false, any = false;
  forEachNeighbour(mesh, v, [&](Vertex neighbour) {
    const bool lower = rank[neighbour] < rank[v];
    if (!any) first = lower;
    runs += any && lower && !before;
    before = lower;
    any = true;
  });
  return runs + (first && !before);
}

/// The vertex, lowest first, at which the disk meets itself without dividing the main part.
Vertex firstHandle(const SurfaceMesh& mesh, const std::vector<Vertex>& order,
                   const std::vector<Index>& rank, const RestParts& parts,
                   const std::vector<double>& leaves) {
  VertexSets sets(mesh.vertexCount());
  for (const Vertex v : order) {
    std::vector<Index> met;
    forEachNeighbour(mesh, v, [&](Vertex neighbour) {
      if (!sets.contains(neighbour)) return;
      const Index root = sets.find(neighbour);
      if (std::find(met.begin(), met.end(), root) == met.end()) met.push_back(root);
    });
    sets.add(v);
    for (const Index root : met) sets.join(root, v);
    if (mesh.isBoundary(v) || !std::isinf(leaves[v])) continue;
    const Index runs = lowerRuns(mesh, rank, v);
    // Each run but one adds a band to what is reached: it joins two parts of that, or divides the
    // rest, or goes round a handle.
    if (runs > 1 && runs + 1 > met.size() + parts.met(v)) return v;
  }
  return Vertex::none;
}

}  // namespace

UnreachedRest unreachedRest(const SurfaceMesh& mesh, std::span<const double> heights,
                            Vertex source) {
  std::vector<Vertex> order;
  for (const Vertex v : mesh.vertices()) {
    if (std::isfinite(heights[v])) order.push_back(v);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](Vertex a, Vertex b) { return heights[a] < heights[b]; });
  std::vector<Index> rank(mesh.vertexCount(), kNoIndex);
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<Index>(i);

  const RestParts parts(mesh, heights, order);
  UnreachedRest rest;
  // From the whole to what it falls apart into: these have lower numbers.
  std::vector<double> leaves(parts.parts().size(), kInfinity);
  Index main = parts.partOf(source);
  for (Index part = static_cast<Index>(parts.parts().size()); part-- > 0;) {
    const RestPart& one = parts.parts()[part];
    for (const Index inner : one.parts) leaves[inner] = leaves[part];
    if (part != main || one.parts.empty()) continue;
    for (std::size_t i = 1; i < one.parts.size(); ++i) leaves[one.parts[i]] = heights[one.split];
    rest.splits.push_back({one.split, parts.depth(one.parts[1], one.split)});
    main = one.parts[0];
  }
  rest.last = parts.parts()[main].highest;
  rest.leaves.assign(mesh.vertexCount(), kInfinity);
  for (const Vertex v : order) rest.leaves[v] = leaves[parts.partOf(v)];
  const auto boundary = std::find_if(order.begin(), order.end(), [&](Vertex v) {
    return mesh.isBoundary(v) && std::isinf(rest.leaves[v]);
  });
  if (boundary != order.end()) rest.boundary = *boundary;
  rest.handle = firstHandle(mesh, order, rank, parts, rest.leaves);
  return rest;
}

}  // namespace girth
