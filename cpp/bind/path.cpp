// The shortest path between two points of a surface, and the girth along shortest paths.

#include <emscripten/bind.h>

#include <cmath>
#include <string>
#include <vector>

#include "boundary.h"
#include "girth/describe/geodesic_solver.h"
#include "girth/describe/path_profile.h"
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
    const Vec3 a = positionOf(mesh, start), b = positionOf(mesh, end);
    ResultObject result(surface.drawn());
    result.addMembers(found.value());
    result("straight", std::hypot(b.x - a.x, b.y - a.y, b.z - a.z));
    return result.object();
  });
}

using Stations = std::vector<PathStation>;

/// A number of JavaScript as a count; 1, which none of the options allows, for one that is none.
std::size_t countOf(double number) {
  return number >= 0 && number < 4e9 && number == std::floor(number)
             ? static_cast<std::size_t>(number)
             : 1;
}

/// The girth along the shortest paths from each of `SurfacePoint[]` to the next.
Result<Stations> stationsAlong(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& path,
                               double samples, bool crossings, const val& onProgress) {
  return girthAlong(mesh, path, {countOf(samples), crossings}, reportingTo(onProgress));
}

/// `GirthPath` of types.ts without its unit, or an error.
val profile(const JobSurface& surface, const val& points, double samples, bool crossings,
            const val& onProgress) {
  return guarded([&] {
    const SurfaceMesh& mesh = surface.mesh();
    const auto path = shortestPathThrough(mesh, curveOf(points));
    if (!path) return toJs(path.error());
    const auto found = stationsAlong(mesh, path.value(), samples, crossings, onProgress);
    if (!found) return toJs(found.error());
    val list = val::array();
    for (const PathStation& station : found.value()) {
      ResultObject entry;
      entry.addMembers(station);
      entry("place", station.point);
      list.call<void>("push", entry.object());
    }
    ResultObject result(surface.drawn());
    result("length", found.value().back().distance);
    result("stations", list);
    result("polyline", Line{path.value()});
    return result.object();
  });
}

EMSCRIPTEN_BINDINGS(girthPath) {
  emscripten::function("path", &path);
  emscripten::function("profile", &profile);
}

}  // namespace
}  // namespace girth::bind
