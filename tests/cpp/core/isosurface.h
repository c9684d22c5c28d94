// Surfaces where a function of space is zero.
#pragma once

#include <functional>

#include "shapes.h"

namespace girth::test {

/// The boundary of {f < 0} within [-size, size]³, by marching tetrahedra on a grid of `cells` cells
/// a side: closed where f > 0 on the cube's sides.
Shape isosurface(const std::function<double(const Vec3&)>& f, double size, Index cells);

/// The distance to a torus about `centre`: of radii R and r, with a unit vector along its axis.
double torusDistance(const Vec3& p, const Vec3& centre, const Vec3& axis, double R, double r);

}  // namespace girth::test
