// The shortest path between two points of a surface.

#include <emscripten/bind.h>

#include <cmath>
#include <vector>

#include "boundary.h"
#include "girth/geodesic_solver.h"
#include "job_surface.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// `SurfacePath` of types.ts without its unit, or an error.
val path(const JobSurface& surface, const val& from, const val& to) {
  return guarded([&] {
    const SurfaceMesh& mesh = surface.mesh();
    const SurfacePoint start = pointOf(from), end = pointOf(to);
    const Result<GeodesicPath> found = GeodesicSolver(mesh).path(start, end);
    if (!found) return toJs(found.error());
    std::vector<Vec3> points;
    for (const SurfacePoint& point : found.value().points)
      points.push_back(positionOf(mesh, point));
    const Vec3 a = positionOf(mesh, start), b = positionOf(mesh, end);
    val result = val::object();
    result.set("length", found.value().length);
    result.set("straight", std::hypot(b.x - a.x, b.y - a.y, b.z - a.z));
    result.set("polyline", drawnPoints(points, surface.origin()));
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthPath) { emscripten::function("path", &path); }

}  // namespace
}  // namespace girth::bind
