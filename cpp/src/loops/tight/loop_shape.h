// Measures of a closed polyline in space.
#pragma once

#include <vector>

#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth::loops {

std::vector<Vec3> placesOf(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points);

struct LoopShape {
  double length{0};
  Vec3 centre;  ///< mean of the points, each part counted by its length
  Vec3 normal;  ///< normal of the plane onto which it casts the largest area; zero where there is
                ///< none
  double radius{0};  ///< mean distance from the centre within that plane
  double area{0};    ///< enclosed in that plane
};

/// The last point equals the first; the length is more than 0.
LoopShape shapeOf(const std::vector<Vec3>& places);

}  // namespace girth::loops
