#include "mesh/prepare/bodies.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

#include "mesh/edge_groups.h"
#include "mesh/prepare/roots.h"
#include "mesh/sides.h"

namespace girth::prepare {

namespace {

class BodyFinder {
 public:
  BodyFinder(std::span<const Index> triangles, const std::vector<Index>& place)
      : triangles_(triangles), place_(place) {}

  std::vector<Index> run(CornerSharing sharing) {
    findEdges();
    if (!findBodies()) return {};
    if (sharing == CornerSharing::Some && !keepSimpleBodies()) return {};
    return firstOfEach();
  }

 private:
  Index placeOf(Index h) const { return place_[triangles_[h]]; }

  /// The edges by place, and the faces that they connect.
  void findEdges() {
    std::vector<Index> places(triangles_.size());
    for (Index h = 0; h < places.size(); ++h) places[h] = placeOf(h);
    edgeOf_.resize(places.size());
    cluster_.resize(places.size() / 3);
    for (Index f = 0; f < cluster_.size(); ++f) cluster_[f] = f;
    Index edges = 0;
    EdgeGroups(places, place_.size()).forEach([&](const EdgeGroup& edge) {
      for (std::size_t i = 0; i < edge.size(); ++i) {
        edgeOf_[edge[i]] = edges;
        unite(cluster_, edge[0] / 3, edge[i] / 3);
      }
      ++edges;
    });
    forth_.assign(edges, 0);
  }

  /// Numbers the bodies of all faces. False: each cluster is one.
  bool findBodies() {
    bodyOf_.resize(cluster_.size());
    std::vector<Index> open(cluster_.size(), 0);  // edges that do not yet close, by cluster
    std::vector<Index> current(cluster_.size(), kNoIndex);
    Index bodies = 0;
    bool isSeveral = false;
    std::vector<bool> hasBegun(cluster_.size(), false);
    for (Index f = 0; f < cluster_.size(); ++f) {
      const Index cluster = rootOf(cluster_, f);
      if (current[cluster] == kNoIndex) {
        current[cluster] = bodies++;
        isSeveral = isSeveral || hasBegun[cluster];
        hasBegun[cluster] = true;
      }
      bodyOf_[f] = current[cluster];
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index from = placeOf(h), to = placeOf(nextSide(h));
        if (from == to) continue;
        std::ptrdiff_t& forth = forth_[edgeOf_[h]];
        if (forth == 0) ++open[cluster];
        forth += from < to ? 1 : -1;
        if (forth == 0) --open[cluster];
      }
      if (open[cluster] == 0) current[cluster] = kNoIndex;
    }
    return isSeveral;
  }

  /// Takes faces out of bodies that have an edge of more than two faces, or a vertex of another
  /// face. False: no body is left.
  bool keepSimpleBodies() {
    const Index bodies = 1 + *std::max_element(bodyOf_.begin(), bodyOf_.end());
    std::vector<bool> isSimple(bodies, true);
    std::vector<Index> bodyOf(place_.size(), kNoIndex);
    for (Index h = 0; h < triangles_.size(); ++h) {
      Index& body = bodyOf[triangles_[h]];
      if (body == kNoIndex) body = bodyOf_[h / 3];
      if (body != bodyOf_[h / 3]) isSimple[body] = isSimple[bodyOf_[h / 3]] = false;
    }
    // The faces of each body at each edge; a body that ends open has an edge of one face, or of
    // two in one direction.
    std::vector<std::tuple<Index, Index, bool>> uses;
    for (Index h = 0; h < triangles_.size(); ++h) {
      const Index from = placeOf(h), to = placeOf(nextSide(h));
      if (from != to) uses.emplace_back(edgeOf_[h], bodyOf_[h / 3], from < to);
    }
    std::sort(uses.begin(), uses.end());
    for (std::size_t i = 0, end; i < uses.size(); i = end) {
      const auto [edge, body, isForth] = uses[i];
      for (end = i + 1; end < uses.size() && std::get<0>(uses[end]) == edge &&
                        std::get<1>(uses[end]) == body;) {
        ++end;
      }
      if (end - i != 2 || isForth == std::get<2>(uses[i + 1])) isSimple[body] = false;
    }
    for (Index& body : bodyOf_) {
      if (!isSimple[body]) body = kNoIndex;
    }
    return std::find(isSimple.begin(), isSimple.end(), true) != isSimple.end();
  }

  std::vector<Index> firstOfEach() const {
    std::vector<Index> bodyOf(place_.size(), kNoIndex);
    for (Index h = 0; h < triangles_.size(); ++h) bodyOf[triangles_[h]] = bodyOf_[h / 3];
    std::vector<Index> first(place_.size()), order;
    for (Index v = 0; v < first.size(); ++v) {
      first[v] = v;
      if (bodyOf[v] != kNoIndex) order.push_back(v);
    }
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      return std::tuple(place_[a], bodyOf[a], a) < std::tuple(place_[b], bodyOf[b], b);
    });
    for (std::size_t i = 1; i < order.size(); ++i) {
      const Index before = order[i - 1], v = order[i];
      if (place_[v] == place_[before] && bodyOf[v] == bodyOf[before]) first[v] = first[before];
    }
    return first;
  }

  std::span<const Index> triangles_;
  const std::vector<Index>& place_;
  std::vector<Index> edgeOf_;          ///< of each halfedge
  std::vector<Index> cluster_;         ///< of each face, on the way to one of its cluster
  std::vector<std::ptrdiff_t> forth_;  ///< of each edge: faces along it less those against it
  std::vector<Index> bodyOf_;          ///< of each face; kNoIndex: of none
};

}  // namespace

std::vector<Index> firstInBody(std::span<const Index> triangles, const std::vector<Index>& place,
                               CornerSharing sharing) {
  return BodyFinder(triangles, place).run(sharing);
}

}  // namespace girth::prepare
