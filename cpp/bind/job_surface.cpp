// The surfaces of the workers for jobs.

#include "job_surface.h"

#include <emscripten/bind.h>

#include <memory>
#include <utility>

using emscripten::val;

namespace girth::bind {
namespace {

/// {surface}: a `JobSurface` of a prepared surface's arrays, which JavaScript must delete; or an
/// error.
val jobSurface(const val& positions, const val& indices, const val& vertexOfInput,
               const val& inputOfVertex) {
  return guarded([&] {
    Result<SurfaceMesh> mesh = surfaceOf(positions, indices);
    if (!mesh) return toJs(mesh.error());
    val result = val::object();
    result.set("surface",
               std::make_shared<JobSurface>(std::move(mesh).value(), copyIn<Index>(vertexOfInput),
                                            copyIn<Index>(inputOfVertex)));
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthJobSurface) {
  emscripten::class_<JobSurface>("JobSurface")
      .smart_ptr<std::shared_ptr<JobSurface>>("JobSurfacePointer");
  emscripten::function("jobSurface", &jobSurface);
}

}  // namespace
}  // namespace girth::bind
