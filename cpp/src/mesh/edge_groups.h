// The halfedges of triangles, sorted by the edge they lie on.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "girth/surface_mesh.h"
#include "mesh/sides.h"

namespace girth {

/// The halfedges of one edge, ascending.
class EdgeGroup {
 public:
  EdgeGroup(const std::uint64_t* entries, std::size_t size) : entries_(entries), size_(size) {}
  std::size_t size() const { return size_; }
  Index operator[](std::size_t i) const { return static_cast<Index>(entries_[i]); }

 private:
  const std::uint64_t* entries_;
  std::size_t size_;
};

/// Groups the halfedges of `triangles` by edge, whatever their direction. Buckets by the lower
/// vertex, each sorted: O(n log n) at worst, and close to linear for meshes. 8 bytes a halfedge and
/// 4 a vertex.
class EdgeGroups {
 public:
  EdgeGroups(std::span<const Index> triangles, std::size_t vertices) : begin_(vertices + 1, 0) {
    const auto count = static_cast<Index>(triangles.size());
    const auto to = [&](Index h) { return triangles[nextSide(h)]; };
    for (Index h = 0; h < count; ++h) ++begin_[std::min(triangles[h], to(h))];
    Index sum = 0;
    for (Index& entry : begin_) {
      sum += entry;
      entry = sum;
    }
    entries_.resize(count);
    for (Index h = count; h-- > 0;) {
      const Index a = triangles[h], b = to(h);
      entries_[--begin_[std::min(a, b)]] = std::uint64_t{std::max(a, b)} << 32 | h;
    }
    for (std::size_t v = 0; v < vertices; ++v) {
      std::sort(entries_.begin() + begin_[v], entries_.begin() + begin_[v + 1]);
    }
  }

  /// Calls `visit` with every group, ascending by lower and then by higher vertex.
  template <class Visit>
  void forEach(Visit&& visit) const {
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v) {
      for (std::size_t i = begin_[v], end; i < begin_[v + 1]; i = end) {
        end = i + 1;
        while (end < begin_[v + 1] && entries_[end] >> 32 == entries_[i] >> 32) ++end;
        visit(EdgeGroup(&entries_[i], end - i));
      }
    }
  }

  /// The halfedges between two vertices.
  EdgeGroup between(Index a, Index b) const {
    const std::uint64_t high = std::max(a, b);
    const auto first = entries_.begin() + begin_[std::min(a, b)];
    const auto last = entries_.begin() + begin_[std::min(a, b) + 1];
    const auto from = std::lower_bound(first, last, high << 32);
    const auto to = std::lower_bound(from, last, (high + 1) << 32);
    return {entries_.data() + (from - entries_.begin()), static_cast<std::size_t>(to - from)};
  }

 private:
  std::vector<std::uint64_t> entries_;  ///< higher vertex and halfedge
  std::vector<Index> begin_;            ///< first entry of each lower vertex
};

}  // namespace girth
