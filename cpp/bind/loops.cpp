// Necks, bottlenecks and handles of a surface, and the surface without small handles.

#include <emscripten/bind.h>

#include "boundary.h"
#include "described.h"
#include "girth/describe/bottleneck.h"
#include "girth/describe/handles.h"
#include "girth/describe/necks.h"
#include "girth/describe/remove_handles.h"
#include "job_surface.h"
#include "result_object.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// `Necks` of types.ts, or an error.
val necks(const JobSurface& surface, const val& girth, double minProminence,
          const val& onProgress) {
  return guarded([&] {
    return objectOf(surface.drawn(), findNecks(surface.mesh(), copyIn<double>(girth),
                                               {minProminence}, reportingTo(onProgress)));
  });
}

/// `Bottleneck` of types.ts, or an error.
val bottleneck(const JobSurface& surface, const val& girth, const val& from, const val& to,
               const val& onProgress) {
  return guarded([&] {
    return objectOf(surface.drawn(),
                    findBottleneck(surface.mesh(), copyIn<double>(girth), pointOf(from),
                                   pointOf(to), reportingTo(onProgress)));
  });
}

HandleOptions handleOptions(double basePoints) {
  return {basePoints >= 1 ? static_cast<std::size_t>(basePoints < 4e9 ? basePoints : 4e9) : 0};
}

/// `Handles` of types.ts, or an error.
val handles(const JobSurface& surface, double basePoints, const val& onProgress) {
  return guarded([&] {
    return objectOf(surface.drawn(), findHandles(surface.mesh(), handleOptions(basePoints),
                                                 reportingTo(onProgress)));
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
    val result = val::object();
    result.set("described", describe(made.value().mesh));
    result.set("removal", ResultObject().addMembers(made.value()).object());
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
