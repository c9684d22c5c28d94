#include "girth/field_difference.h"

#include <cmath>
#include <vector>

#include "girth/distribution.h"
#include "girth/vertex_areas.h"

namespace girth {

namespace {

/// The distribution of the values over the root of the surface's area.
Distribution scaledDistribution(const SurfaceMesh& mesh, std::span<const double> values) {
  const double scale = std::sqrt(mesh.area());
  std::vector<double> scaled(values.begin(), values.end());
  for (double& value : scaled) value /= scale;
  return distributionOf(scaled, vertexAreas(mesh));
}

}  // namespace

double fieldDifference(const SurfaceMesh& mesh1, std::span<const double> values1,
                       const SurfaceMesh& mesh2, std::span<const double> values2) {
  return earthMoversDistance(scaledDistribution(mesh1, values1),
                             scaledDistribution(mesh2, values2));
}

}  // namespace girth
