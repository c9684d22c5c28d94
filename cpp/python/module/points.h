// Points of a surface as Python passes them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "girth/surface_point.h"

namespace girth::python {

/// (number, weights): a vertex where there are no weights, otherwise a point of a face.
using Point = std::pair<std::int64_t, std::vector<double>>;

inline SurfacePoint pointOf(const Point& point) {
  const auto& [element, weights] = point;
  const auto number =
      element >= 0 && element < std::int64_t{kNoIndex} ? static_cast<Index>(element) : kNoIndex;
  if (weights.size() != 3) return SurfacePoint::atVertex(Vertex(number));
  return SurfacePoint::inFace(Face(number), {weights[0], weights[1], weights[2]});
}

}  // namespace girth::python
