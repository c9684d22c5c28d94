// Curves through points at equal steps, as polynomials near each of them.
#pragma once

#include <cstddef>
#include <span>

#include "girth/surface_mesh.h"

namespace girth::tubes {

/// The derivatives of a curve by its parameter.
struct LocalFit {
  Vec3 first, second, third;
};

/// The cubic that is nearest, by least squares, to the points at most `reach` steps from one of
/// them; at the ends as many are taken on the other side. With fewer than five points of the degree
/// that they determine twice over, at least a line. `steps`: of the points, in model units, rising;
/// at least two points.
LocalFit fitAt(std::span<const Vec3> points, std::span<const double> steps, std::size_t place,
               std::size_t reach);

}  // namespace girth::tubes
