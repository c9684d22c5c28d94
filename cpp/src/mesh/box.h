// Boxes along the axes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "girth/surface_mesh.h"

namespace girth {

/// The least box along x, y and z that holds some points, at least one.
struct Box {
  std::array<double, 3> low, high;

  explicit Box(std::span<const Vec3> places) {
    const Vec3& first = places[0];
    low = high = {first.x, first.y, first.z};
    for (const Vec3& p : places) {
      const std::array<double, 3> of{p.x, p.y, p.z};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], of[k]);
        high[k] = std::max(high[k], of[k]);
      }
    }
  }

  bool overlaps(const Box& other) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
    }
    return true;
  }
};

}  // namespace girth
