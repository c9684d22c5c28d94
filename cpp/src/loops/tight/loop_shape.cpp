#include "loops/tight/loop_shape.h"

#include "mesh/vector.h"

namespace girth::loops {

std::vector<Vec3> placesOf(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points) {
  std::vector<Vec3> places;
  places.reserve(points.size());
  for (const SurfacePoint& point : points) places.push_back(positionOf(mesh, point));
  return places;
}

LoopShape shapeOf(const std::vector<Vec3>& places) {
  LoopShape shape;
  Vec3 sum, doubled;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double part = norm(places[i + 1] - places[i]);
    sum = sum + (part / 2) * (places[i] + places[i + 1]);
    doubled = doubled + cross(places[i] - places[0], places[i + 1] - places[0]);
    shape.length += part;
  }
  shape.centre = (1 / shape.length) * sum;
  const double area = norm(doubled) / 2;
  shape.area = area;
  if (area > 0) shape.normal = (0.5 / area) * doubled;
  double radius = 0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    // Simpson's rule on each part.
    const auto distance = [&](const Vec3& p) {
      const Vec3 d = p - shape.centre;
      return norm(d - dot(d, shape.normal) * shape.normal);
    };
    radius += norm(places[i + 1] - places[i]) *
              (distance(places[i]) + 4 * distance(0.5 * (places[i] + places[i + 1])) +
               distance(places[i + 1])) /
              6;
  }
  shape.radius = radius / shape.length;
  return shape;
}

}  // namespace girth::loops
