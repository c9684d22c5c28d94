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
  BodyFinder(std::vector<Index>& triangles, std::vector<Index>& place)
      : triangles_(triangles), place_(place) {}

  Bodies run() {
    findEdges();
    if (!findBodies()) return {};
    if (!isOfFacets() && !keepSimpleBodies()) return {};
    Bodies bodies;
    bodies.copied = copyShared();
    bodies.first = firstOfEach();
    return bodies;
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
    isSeveral_.assign(cluster_.size(), false);
    std::vector<bool> hasBegun(cluster_.size(), false);
    for (Index f = 0; f < cluster_.size(); ++f) {
      const Index cluster = rootOf(cluster_, f);
      if (current[cluster] == kNoIndex) {
        current[cluster] = bodies++;
        isSeveral_[cluster] = hasBegun[cluster];
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
    return std::find(isSeveral_.begin(), isSeveral_.end(), true) != isSeveral_.end();
  }

  /// Whether every corner is a vertex of its own.
  bool isOfFacets() const {
    const std::size_t unused =
        static_cast<std::size_t>(std::count(place_.begin(), place_.end(), kNoIndex));
    return place_.size() - unused == triangles_.size();
  }

  /// Keeps the bodies of clusters in which each edge of a body has two faces. False: none is left.
  bool keepSimpleBodies() {
    std::vector<std::tuple<Index, Index, Index>> uses;  // edge, body, halfedge
    for (Index h = 0; h < triangles_.size(); ++h) {
      if (placeOf(h) != placeOf(nextSide(h))) uses.emplace_back(edgeOf_[h], bodyOf_[h / 3], h);
    }
    std::sort(uses.begin(), uses.end());
    std::vector<bool> isKept = isSeveral_;
    const auto edgeOfBody = [&](std::size_t i) {
      return std::pair(std::get<0>(uses[i]), std::get<1>(uses[i]));
    };
    for (std::size_t i = 0, end; i < uses.size(); i = end) {
      for (end = i + 1; end < uses.size() && edgeOfBody(end) == edgeOfBody(i);) ++end;
      const Index h = std::get<2>(uses[i]), last = std::get<2>(uses[end - 1]);
      const bool isSimple = end - i == 2 && placeOf(h) != placeOf(last);
      if (!isSimple) isKept[rootOf(cluster_, h / 3)] = false;
    }
    for (Index f = 0; f < bodyOf_.size(); ++f) {
      if (!isKept[rootOf(cluster_, f)]) bodyOf_[f] = kNoIndex;
    }
    return std::find(isKept.begin(), isKept.end(), true) != isKept.end();
  }

  /// Gives the faces of each body vertices that no other face has. Returns those they copy.
  std::vector<Index> copyShared() {
    std::vector<std::tuple<Index, Index, Index>> uses;  // vertex, body, corner
    for (Index h = 0; h < triangles_.size(); ++h) {
      uses.emplace_back(triangles_[h], bodyOf_[h / 3], h);
    }
    std::sort(uses.begin(), uses.end());
    std::vector<Index> copied;
    for (std::size_t i = 1; i < uses.size(); ++i) {
      const auto& [vertexBefore, bodyBefore, cornerBefore] = uses[i - 1];
      const auto& [vertex, body, corner] = uses[i];
      if (vertex != vertexBefore) continue;
      if (body != bodyBefore) {
        copied.push_back(vertex);
        triangles_[corner] = static_cast<Index>(place_.size());
        place_.push_back(place_[vertex]);
      } else {
        triangles_[corner] = triangles_[cornerBefore];
      }
    }
    return copied;
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

  std::vector<Index>& triangles_;
  std::vector<Index>& place_;
  std::vector<Index> edgeOf_;          ///< edges by halfedge
  std::vector<Index> cluster_;         ///< by face, on the way to one of its cluster
  std::vector<bool> isSeveral_;        ///< by cluster, at its root: whether it has bodies
  std::vector<std::ptrdiff_t> forth_;  ///< by edge: faces along it less those against it
  std::vector<Index> bodyOf_;          ///< bodies by face; kNoIndex: none
};

}  // namespace

Bodies separateBodies(std::vector<Index>& triangles, std::vector<Index>& place) {
  return BodyFinder(triangles, place).run();
}

}  // namespace girth::prepare
