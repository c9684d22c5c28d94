// Curves on a surface as Python keeps them: plain arrays, so that results can be pickled.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "arrays.h"
#include "girth/cut_surface.h"

namespace girth::python {

/// Points as two arrays: their kinds (as SurfacePoint::Kind) and the numbers of their elements,
/// shape (k, 2); and their weights, shape (k, 3).
using CurveArrays = std::pair<Array<std::int64_t>, Array<double>>;

inline CurveArrays curveOf(std::span<const SurfacePoint> points) {
  std::vector<std::int64_t> elements;
  std::vector<double> weights;
  for (const SurfacePoint& point : points) {
    elements.insert(elements.end(), {static_cast<std::int64_t>(point.kind), point.element});
    weights.insert(weights.end(), point.weights.begin(), point.weights.end());
  }
  const auto count = static_cast<pybind11::ssize_t>(points.size());
  return {arrayOf(std::move(elements), {count, 2}), arrayOf(std::move(weights), {count, 3})};
}

/// Points of no surface, where the numbers are none.
inline SurfaceCurve pointsOf(const CurveArrays& curve) {
  const auto elements = spanOf(curve.first);
  const auto weights = spanOf(curve.second);
  SurfaceCurve points(std::min(elements.size() / 2, weights.size() / 3));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int64_t kind = elements[2 * i], element = elements[2 * i + 1];
    points[i].kind = kind == 0   ? SurfacePoint::Kind::AtVertex
                     : kind == 1 ? SurfacePoint::Kind::OnEdge
                                 : SurfacePoint::Kind::InFace;
    points[i].element =
        element >= 0 && element < std::int64_t{kNoIndex} ? static_cast<Index>(element) : kNoIndex;
    points[i].weights = {weights[3 * i], weights[3 * i + 1], weights[3 * i + 2]};
  }
  return points;
}

}  // namespace girth::python
