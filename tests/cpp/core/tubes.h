// Tubes along closed curves.
#pragma once

#include <functional>

#include "shapes.h"

namespace girth::test {

/// A tube of radius r along a closed curve, given over [0, 1]: `around` sections of `across`
/// corners, in planes across the curve, turned so that they meet. Corner j of section i is the
/// vertex i × across + j.
Shape tube(const std::function<Vec3(double)>& curve, double radius, Index around, Index across);

/// A ring of 200 sections round a circle of radius 10, each a regular polygon of `sides` corners.
/// Its radii rise and fall between 0.9 and 1 with every eighth section; that of section `narrow` is
/// 0.8: the shortest loop round the ring by far.
Shape wavyRing(Index narrow, Index sides);

/// A trefoil knot within a torus of radii 2 and 1, over [0, 1].
Vec3 trefoil(double t);

}  // namespace girth::test
