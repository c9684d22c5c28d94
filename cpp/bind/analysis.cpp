// Tips, limbs, parts, maxima and weak places of a surface, and the areas of its vertices.

#include "analysis.h"

#include <emscripten/bind.h>

#include "girth/describe/limbs.h"
#include "girth/describe/parts.h"
#include "girth/describe/print_check.h"
#include "girth/vertex_areas.h"
#include "job_surface.h"
#include "maxima.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// {areas} of the vertices, or an error.
val areasOfVertices(const JobSurface& surface) {
  return guarded([&] {
    val result = val::object();
    result.set("areas", copyOut<double>("Float64Array", vertexAreas(surface.mesh())));
    return result;
  });
}

/// `FoundTips` of protocol.ts, or an error.
val tips(const JobSurface& surface, const val& girth) {
  return guarded([&] {
    const Result<Tips> found = findTips(surface.mesh(), copyIn<double>(girth));
    return found ? tipsWithPoints(surface.drawn(), found.value()) : toJs(found.error());
  });
}

/// `Limbs` of types.ts, or an error.
val limbs(const JobSurface& surface, const val& girth, double stations, const val& onProgress) {
  return guarded([&] {
    return objectOf(surface.drawn(), limbsByGirth(surface.mesh(), copyIn<double>(girth), stations,
                                                  reportingTo(onProgress)));
  });
}

/// {girth, shapeDiameter}, or an error.
val thresholds(const JobSurface& surface, const val& fields) {
  return guarded([&] {
    const GirthAndDiameter values(fields);
    const PartThresholds found = suggestedThresholds(surface.mesh(), values.girth, values.diameter);
    return ResultObject().addMembers(found).object();
  });
}

/// `Parts` of types.ts, or an error.
val parts(const JobSurface& surface, const val& fields, const val& options) {
  return guarded([&] {
    const GirthAndDiameter values(fields);
    const Result<Parts> found =
        findParts(surface.mesh(), values.girth, values.diameter, partOptionsOf(options));
    if (!found) return toJs(found.error());
    ResultObject result;
    result("kinds", kindCodes(found.value().kinds));
    result("partOf", copyOut<Index>("Uint32Array", found.value().partOf));
    result("parts", found.value().parts);
    return result.object();
  });
}

/// {maxima} of the values, or of their negatives, or an error.
val maxima(const JobSurface& surface, const val& values, bool minima) {
  return guarded([&] {
    std::vector<double> heights = copyIn<double>(values);
    const double sign = minima ? -1 : 1;
    for (double& height : heights) height *= sign;
    auto found = persistentMaxima(surface.mesh(), heights);
    if (!found) return toJs(found.error());
    for (PersistentMaximum& maximum : found.value()) maximum.value *= sign;
    return maximaOf(found.value());
  });
}

/// `PrintCheck` of types.ts, or an error.
val printCheck(const JobSurface& surface, const val& fields, const val& limits,
               const val& onProgress) {
  return guarded([&] {
    return objectOf(surface.drawn(), printCheckOf(surface.mesh(), fields, limitsOf(limits),
                                                  reportingTo(onProgress)));
  });
}

EMSCRIPTEN_BINDINGS(girthAnalysis) {
  emscripten::function("vertexAreas", &areasOfVertices);
  emscripten::function("tips", &tips);
  emscripten::function("limbs", &limbs);
  emscripten::function("suggestedThresholds", &thresholds);
  emscripten::function("parts", &parts);
  emscripten::function("maxima", &maxima);
  emscripten::function("printCheck", &printCheck);
}

}  // namespace
}  // namespace girth::bind
