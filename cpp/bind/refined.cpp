// The refined girth on one thread, for pages without shared memory.

#include "refined.h"

#include <emscripten/bind.h>

#include "job_surface.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// `FoundRefined` of protocol.ts, or an error.
val refined(const JobSurface& surface, const val& request, const val& onProgress) {
  return guarded([&] { return refinedOf(surface.mesh(), request, reportingTo(onProgress)); });
}

EMSCRIPTEN_BINDINGS(girthRefined) { emscripten::function("refinedGirth", &refined); }

}  // namespace
}  // namespace girth::bind
