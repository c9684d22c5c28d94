// Necks and handles of a surface.

#include <emscripten/bind.h>

#include "boundary.h"
#include "described.h"
#include "girth/handles.h"
#include "girth/necks.h"
#include "job_surface.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// `ClosedLoop` of types.ts.
val closedLoop(const JobSurface& surface, const std::vector<SurfacePoint>& points, double length,
               const Vec3& centre, double area) {
  val places = val::array();
  std::vector<Vec3> drawn;
  drawn.reserve(points.size());
  for (const SurfacePoint& point : points) {
    places.call<void>("push", surfacePointOf(point));
    drawn.push_back(positionOf(surface.mesh(), point));
  }
  val result = val::object();
  result.set("length", length);
  result.set("points", places);
  result.set("polyline", drawnPoints(drawn, surface.origin()));
  result.set("centre", tripleOf(centre));
  result.set("area", area);
  return result;
}

/// `Neck` of types.ts.
val neckOf(const JobSurface& surface, const Neck& neck) {
  val sides = val::array();
  for (const CurveSide& side : neck.sides) {
    val entry = val::object();
    entry.set("area", side.area);
    entry.set("volume", side.volume);
    sides.call<void>("push", entry);
  }
  val result = closedLoop(surface, neck.points, neck.length, neck.centre, neck.area);
  result.set("prominence", neck.prominence);
  result.set("width", neck.width);
  result.set("vertices", copyOut<Index>("Uint32Array", numbersOf(neck.vertices)));
  result.set("normal", tripleOf(neck.normal));
  result.set("radius", neck.radius);
  result.set("sides", sides);
  result.set("measuresGirth", neck.measuresGirth);
  result.set("touchesBoundary", neck.touchesBoundary);
  return result;
}

/// `Necks` of types.ts, or an error.
val necks(const JobSurface& surface, const val& girth, double minProminence,
          const val& onProgress) {
  return guarded([&] {
    const Result<Necks> found =
        findNecks(surface.mesh(), copyIn<double>(girth), {minProminence}, reportingTo(onProgress));
    if (!found) return toJs(found.error());
    val list = val::array();
    for (const Neck& neck : found.value().necks) list.call<void>("push", neckOf(surface, neck));
    val result = val::object();
    result.set("necks", list);
    result.set("unresolved", found.value().unresolved);
    return result;
  });
}

/// `Handles` of types.ts, or an error.
val handles(const JobSurface& surface, double basePoints, const val& onProgress) {
  return guarded([&] {
    const HandleOptions options{
        basePoints >= 1 ? static_cast<std::size_t>(basePoints < 4e9 ? basePoints : 4e9) : 0};
    const Result<Handles> found = findHandles(surface.mesh(), options, reportingTo(onProgress));
    if (!found) return toJs(found.error());
    val list = val::array();
    for (const Handle& handle : found.value().handles) {
      val entry = closedLoop(surface, handle.points, handle.length, handle.centre, handle.area);
      entry.set("kind", std::string(toString(handle.kind)));
      entry.set("component", handle.component);
      list.call<void>("push", entry);
    }
    val result = val::object();
    result.set("handles", list);
    result.set("unresolved", found.value().unresolved);
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthLoops) {
  emscripten::function("necks", &necks);
  emscripten::function("handles", &handles);
}

}  // namespace
}  // namespace girth::bind
