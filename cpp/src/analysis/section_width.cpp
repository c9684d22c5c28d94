#include <utility>
#include <vector>

#include "analysis/convex_hull.h"
#include "analysis/plane_frame.h"
#include "girth/print_check.h"
#include "mesh/vector.h"

namespace girth {

double sectionWidth(const SurfaceMesh& mesh, const GirthLoop& loop) {
  if (loop.kind != LoopKind::Loop) return 0;
  const std::vector<Vec3> points = polyline(mesh, loop);
  if (points.size() < 3) return 0;
  // Normal to the mean plane (Newell); lengths are shares of the loop's, so that nothing overflows.
  const double unit = 1 / loop.length;
  Vec3 normal{};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    normal = normal + cross(unit * (points[i] - points[0]), unit * (points[i + 1] - points[0]));
  }
  const double area = norm(normal);
  if (!(area > 0)) return 0;
  normal = (1 / area) * normal;
  const PlaneFrame frame(normal);
  std::vector<Point2> flat;
  for (const Vec3& p : points) {
    const Vec3 d = unit * (p - points[0]);
    flat.push_back(frame.flat(d));
  }
  return loop.length * widthsOf(convexHull(std::move(flat))).least;
}

}  // namespace girth
