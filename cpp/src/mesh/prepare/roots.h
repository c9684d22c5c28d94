// Elements that are united: each names another one of its set, or itself.
#pragma once

#include <algorithm>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::prepare {

/// The one that stands for an element in the end. Shortens the way there.
inline Index rootOf(std::vector<Index>& first, Index v) {
  while (first[v] != v) {
    first[v] = first[first[v]];
    v = first[v];
  }
  return v;
}

/// Makes one set of those of two elements; the lowest one stands for it.
inline void unite(std::vector<Index>& first, Index a, Index b) {
  a = rootOf(first, a);
  b = rootOf(first, b);
  first[std::max(a, b)] = std::min(a, b);
}

}  // namespace girth::prepare
