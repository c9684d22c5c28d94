// Where a function has one value.
#include "girth/level_curves.h"

#include <emscripten/bind.h>

#include "boundary.h"
#include "job_surface.h"
#include "result_object.h"

using emscripten::val;

namespace girth::bind {
namespace {

bool isClosed(const SurfaceCurve& curve) {
  const SurfacePoint &first = curve.front(), &last = curve.back();
  return first.kind == last.kind && first.element == last.element && first.weights == last.weights;
}

/// {curves}: `LevelCurve[]` of types.ts; or an error.
val levelCurvesOf(const JobSurface& surface, const val& values, double level) {
  return guarded([&] {
    const Result<std::vector<SurfaceCurve>> found =
        levelCurves(surface.mesh(), copyIn<double>(values), level);
    if (!found) return toJs(found.error());
    val curves = val::array();
    for (const SurfaceCurve& curve : found.value()) {
      ResultObject entry(surface.drawn());
      entry("points", Curve{curve});
      entry("closed", isClosed(curve));
      curves.call<void>("push", entry.object());
    }
    val result = val::object();
    result.set("curves", curves);
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthLevelCurves) { emscripten::function("levelCurves", &levelCurvesOf); }

}  // namespace
}  // namespace girth::bind
