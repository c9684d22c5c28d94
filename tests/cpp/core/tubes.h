// Tubes along closed curves.
#pragma once

#include <functional>

#include "shapes.h"

namespace girth::test {

/// A tube of radius r along a closed curve, given over [0, 1]: `around` sections of `across`
/// corners, in planes across the curve, turned so that they meet. Corner j of section i is the
/// vertex i × across + j.
Shape tube(const std::function<Vec3(double)>& curve, double radius, Index around, Index across);

/// A trefoil knot within a torus of radii 2 and 1, over [0, 1].
Vec3 trefoil(double t);

}  // namespace girth::test
