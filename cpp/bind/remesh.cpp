// Other triangles for the same surface, and fields from one triangulation to another.

#include "girth/remesh.h"

#include <emscripten/bind.h>

#include <utility>

#include "boundary.h"
#include "described.h"
#include "girth/field_difference.h"
#include "girth/transfer.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// The girth differs by at most twice the distance along the surface, but where it jumps
/// (web/docs/definitions.md, section 2).
constexpr double kSteepestGirth = 2;

/// A surface of about `faces` faces, as `describe` gives it, or an error.
val remeshSurface(const val& positions, const val& indices, double faces, const val& onProgress) {
  return guarded([&] {
    const Result<SurfaceMesh> mesh = bind::surfaceOf(positions, indices);
    if (!mesh) return toJs(mesh.error());
    const bool isNumber = faces >= 0 && faces <= 4e9;
    const RemeshOptions options{isNumber ? static_cast<Index>(faces) : 0};
    const Result<RemeshedSurface> remeshed = remesh(mesh.value(), options, reportingTo(onProgress));
    if (!remeshed) return toJs(remeshed.error());
    return describe(remeshed.value().mesh);
  });
}

/// {values} of a remeshed surface at the vertices of the original, or an error.
val carryBack(const val& original, const val& remeshed, const val& values) {
  return guarded([&] {
    const Result<SurfaceMesh> to = surfaceOf(original);
    if (!to) return toJs(to.error());
    const Result<SurfaceMesh> from = surfaceOf(remeshed);
    if (!from) return toJs(from.error());
    const std::vector<SurfacePoint> places = nearestPoints(from.value(), to.value());
    const std::vector<double> carried =
        interpolated(from.value(), copyIn<double>(values), places, kSteepestGirth);
    val result = val::object();
    result.set("values", copyOut<double>("Float64Array", carried));
    return result;
  });
}

/// {difference} of two fields, each {positions, indices, values}, or an error.
val difference(const val& one, const val& other) {
  return guarded([&] {
    const Result<SurfaceMesh> first = surfaceOf(one);
    if (!first) return toJs(first.error());
    const Result<SurfaceMesh> second = surfaceOf(other);
    if (!second) return toJs(second.error());
    val result = val::object();
    result.set("difference", fieldDifference(first.value(), copyIn<double>(one["values"]),
                                             second.value(), copyIn<double>(other["values"])));
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthRemesh) {
  emscripten::function("remesh", &remeshSurface);
  emscripten::function("carryBack", &carryBack);
  emscripten::function("difference", &difference);
}

}  // namespace
}  // namespace girth::bind
