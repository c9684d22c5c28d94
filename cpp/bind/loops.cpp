// Necks, bottlenecks and handles of a surface, and the surface without small handles.

#include <emscripten/bind.h>

#include "boundary.h"
#include "described.h"
#include "drawn_curve.h"
#include "girth/bottleneck.h"
#include "girth/handles.h"
#include "girth/necks.h"
#include "girth/remove_handles.h"
#include "job_surface.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// `ClosedLoop` of types.ts without its length.
val closedLoop(const JobSurface& surface, const std::vector<SurfacePoint>& points,
               const Vec3& centre, double area) {
  val result = drawnCurve(surface, points);
  result.set("centre", tripleOf(centre));
  result.set("area", area);
  return result;
}

/// `LoopSide[]` of types.ts.
val sidesOf(const std::vector<CurveSide>& sides) {
  val list = val::array();
  for (const CurveSide& side : sides) {
    val entry = val::object();
    entry.set("area", side.area);
    entry.set("volume", side.volume);
    list.call<void>("push", entry);
  }
  return list;
}

/// `Neck` of types.ts.
val neckOf(const JobSurface& surface, const Neck& neck) {
  val result = closedLoop(surface, neck.points, neck.centre, neck.area);
  result.set("length", neck.length);
  result.set("prominence", neck.prominence);
  result.set("width", neck.width);
  result.set("vertices", copyOut<Index>("Uint32Array", numbersOf(neck.vertices)));
  result.set("normal", tripleOf(neck.normal));
  result.set("radius", neck.radius);
  result.set("sides", sidesOf(neck.sides));
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

/// `Bottleneck` of types.ts, or an error.
val bottleneck(const JobSurface& surface, const val& girth, const val& from, const val& to,
               const val& onProgress) {
  return guarded([&] {
    const Result<Bottleneck> found = findBottleneck(
        surface.mesh(), copyIn<double>(girth), pointOf(from), pointOf(to), reportingTo(onProgress));
    if (!found) return toJs(found.error());
    const Bottleneck& one = found.value();
    val way = val::array();
    for (const SurfacePoint& point : one.way) way.call<void>("push", surfacePointOf(point));
    val result = closedLoop(surface, one.points, one.centre, one.area);
    result.set("girth", one.girth);
    result.set("kind", std::string(toString(one.kind)));
    result.set("place", surfacePointOf(one.place));
    result.set("sides", sidesOf(one.sides));
    result.set("way", way);
    return result;
  });
}

HandleOptions handleOptions(double basePoints) {
  return {basePoints >= 1 ? static_cast<std::size_t>(basePoints < 4e9 ? basePoints : 4e9) : 0};
}

/// `Handles` of types.ts, or an error.
val handles(const JobSurface& surface, double basePoints, const val& onProgress) {
  return guarded([&] {
    const Result<Handles> found =
        findHandles(surface.mesh(), handleOptions(basePoints), reportingTo(onProgress));
    if (!found) return toJs(found.error());
    val list = val::array();
    for (const Handle& handle : found.value().handles) {
      val entry = closedLoop(surface, handle.points, handle.centre, handle.area);
      entry.set("length", handle.length);
      entry.set("kind", std::string(toString(handle.kind)));
      entry.set("component", handle.component);
      entry.set("mayBeShorterBy", handle.mayBeShorterBy);
      list.call<void>("push", entry);
    }
    val result = val::object();
    result.set("handles", list);
    result.set("unresolved", found.value().unresolved);
    return result;
  });
}

/// {described, removal}: the surface without its handles that are shorter than a length, as
/// `describe` gives it, and `HandleRemoval` of types.ts; or an error.
val surfaceWithoutHandles(const JobSurface& surface, double length, double basePoints,
                          const val& onProgress) {
  return guarded([&] {
    const Result<HandleRemoval> made =
        removeHandles(surface.mesh(), length, handleOptions(basePoints), reportingTo(onProgress));
    if (!made) return toJs(made.error());
    val removed = val::array();
    for (const Handle& handle : made.value().removed) {
      val entry = val::object();
      entry.set("kind", std::string(toString(handle.kind)));
      entry.set("length", handle.length);
      entry.set("centre", tripleOf(handle.centre));
      removed.call<void>("push", entry);
    }
    val removal = val::object();
    removal.set("removed", removed);
    removal.set("genusBefore", made.value().genusBefore);
    removal.set("genusAfter", made.value().genusAfter);
    removal.set("crossingFaces", made.value().crossingFaces);
    removal.set("provenLength", made.value().provenLength);
    val result = val::object();
    result.set("described", describe(made.value().mesh));
    result.set("removal", removal);
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthLoops) {
  emscripten::function("necks", &necks);
  emscripten::function("bottleneck", &bottleneck);
  emscripten::function("removeHandles", &surfaceWithoutHandles);
  emscripten::function("handles", &handles);
}

}  // namespace
}  // namespace girth::bind
