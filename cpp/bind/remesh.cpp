// Remeshing, smoothing, and fields carried from one mesh of a surface to another.

#include "girth/remesh.h"

#include <emscripten/bind.h>

#include <utility>

#include "boundary.h"
#include "girth/field_difference.h"
#include "girth/smooth_surface.h"
#include "girth/transfer.h"
#include "job_surface.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// {described}: a surface as `describe` gives it.
val made(const SurfaceMesh& mesh) {
  val result = val::object();
  result.set("described", describe(mesh));
  return result;
}

/// {described} of a surface of about `faces` faces, of even size or as fits the shape, or an error.
val remeshSurface(const JobSurface& surface, double faces, bool even, const val& onProgress) {
  return guarded([&] {
    const bool isNumber = faces >= 0 && faces <= 4e9;
    const RemeshOptions options{isNumber ? static_cast<Index>(faces) : 0,
                                even ? RemeshMethod::Even : RemeshMethod::Fitting};
    const Result<RemeshedSurface> remeshed =
        remesh(surface.mesh(), options, reportingTo(onProgress));
    if (!remeshed) return toJs(remeshed.error());
    return made(remeshed.value().mesh);
  });
}

/// {described} of the surface with its vertices moved, or an error.
val smoothed(const JobSurface& surface, double steps, const val& onProgress) {
  return guarded([&] {
    const Result<SurfaceMesh> smooth =
        smoothSurface(surface.mesh(), indexOf(steps), reportingTo(onProgress));
    if (!smooth) return toJs(smooth.error());
    return made(smooth.value());
  });
}

/// {values, kinds} of a remeshed surface at the vertices of the original, or an error. Kinds, which
/// only a girth has, are those of the nearest vertices.
val carryBack(const JobSurface& original, const JobSurface& remeshed, const val& values,
              const val& kinds) {
  return guarded([&] {
    const std::vector<SurfacePoint> places = nearestPoints(remeshed.mesh(), original.mesh());
    const auto field = copyIn<double>(values);
    const auto known = copyIn<std::uint8_t>(kinds);
    std::vector<double> carried;
    std::vector<std::uint8_t> nearest;
    if (known.empty()) {
      carried = interpolated(remeshed.mesh(), field, places, kSteepestGirth);
    } else {
      carried = carriedBack(remeshed.mesh(), field, original.mesh(), places);
      for (const Vertex v : nearestVertices(remeshed.mesh(), places)) nearest.push_back(known[v]);
    }
    val result = val::object();
    result.set("values", copyOut<double>("Float64Array", carried));
    result.set("kinds", copyOut<std::uint8_t>("Uint8Array", nearest));
    return result;
  });
}

/// {difference} of two fields, each on its surface, or an error.
val difference(const JobSurface& one, const val& values, const JobSurface& other,
               const val& otherValues) {
  return guarded([&] {
    val result = val::object();
    result.set("difference", fieldDifference(one.mesh(), copyIn<double>(values), other.mesh(),
                                             copyIn<double>(otherValues)));
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthRemesh) {
  emscripten::function("remesh", &remeshSurface);
  emscripten::function("smooth", &smoothed);
  emscripten::function("carryBack", &carryBack);
  emscripten::function("difference", &difference);
}

}  // namespace
}  // namespace girth::bind
