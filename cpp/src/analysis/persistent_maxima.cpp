#include "girth/persistent_maxima.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "mesh/neighbours.h"

namespace girth {

Result<std::vector<PersistentMaximum>> persistentMaxima(const SurfaceMesh& mesh,
                                                        std::span<const double> values) {
  const Index n = mesh.vertexCount();
  if (values.size() != n) {
    return makeError(
        ErrorCode::Usage, -1,
        std::to_string(values.size()) + " values for " + std::to_string(n) + " vertices");
  }
  std::vector<Index> order(n), rank(n, kNoIndex);
  std::iota(order.begin(), order.end(), Index{0});
  std::erase_if(order, [&](Index v) { return std::isnan(values[v]); });
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return values[a] > values[b]; });
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<Index>(i);

  // From high to low: each vertex joins the regions of its higher neighbours. A region is named by
  // its highest vertex, which is the one of least rank.
  std::vector<Index> parent(n, kNoIndex);
  const auto regionOf = [&](Index v) {
    while (parent[v] != v) {
      parent[v] = parent[parent[v]];
      v = parent[v];
    }
    return v;
  };
  std::vector<PersistentMaximum> maxima;
  for (const Index v : order) {
    parent[v] = v;
    forEachNeighbour(mesh, Vertex(v), [&](Vertex neighbour) {
      if (rank[neighbour] == kNoIndex || rank[neighbour] > rank[v]) return;
      Index higher = regionOf(v), lower = regionOf(neighbour);
      if (higher == lower) return;
      if (rank[higher] > rank[lower]) std::swap(higher, lower);
      parent[lower] = higher;
      // The vertex itself has no region of its own.
      if (lower == v || !(values[lower] > values[v])) return;
      maxima.push_back({Vertex(lower), values[lower], values[lower] - values[v], Vertex(v)});
    });
  }
  // Maxima that met none higher: the highest of each component, down to its lowest value.
  std::vector<double> least(n);
  for (const Index v : order) least[regionOf(v)] = values[v];
  for (const Index v : order) {
    if (parent[v] != v) continue;
    maxima.push_back({Vertex(v), values[v], values[v] - least[v], Vertex::none});
  }
  std::stable_sort(maxima.begin(), maxima.end(),
                   [](const PersistentMaximum& a, const PersistentMaximum& b) {
                     return a.persistence > b.persistence;
                   });
  return maxima;
}

}  // namespace girth
