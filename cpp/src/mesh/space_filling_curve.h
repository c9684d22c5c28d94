// An order of points in space in which neighbours stay near each other.
#pragma once

#include <vector>

#include "girth/surface_mesh.h"

namespace girth {

/// The numbers of the points, along Morton's curve through the cube around them. O(n log n).
std::vector<Index> alongCurve(const std::vector<Vec3>& points);

}  // namespace girth
