// The analyses of the table: girth/analyses.def.

#include <emscripten/bind.h>

#include <string>

#include "boundary.h"
#include "girth/analyses.def"
#include "job_surface.h"
#include "result_again.h"
#include "result_object.h"

using emscripten::val;

namespace girth::bind {
namespace {

template <Described Options, Described Found>
val resultOf(const JobSurface& surface, const val& request, const val& onProgress,
             Result<Found> (*analysis)(const SurfaceMesh&, const Options&,
                                       const ExecutionContext&)) {
  Options options;
  ResultAgain again = ResultAgain::ofOptions(surface.mesh());
  again.read(request, options);
  if (!again.problem().empty()) return toJs(makeError(ErrorCode::Usage, -1, again.problem()));
  return objectOf(surface.drawn(), analysis(surface.mesh(), options, reportingTo(onProgress)));
}

/// The result of an analysis by its name, or an error. `request`: its options.
val analyse(const JobSurface& surface, const std::string& name, const val& request,
            const val& onProgress) {
  return guarded([&] {
#define GIRTH_ANALYSIS(analysis, Options, Found, function) \
  if (name == #analysis) return resultOf(surface, request, onProgress, function);
#include "girth/analyses.def"
    return toJs(makeError(ErrorCode::Usage, -1, "there is no analysis '" + name + "'"));
  });
}

EMSCRIPTEN_BINDINGS(girthAnalyses) { emscripten::function("analyse", &analyse); }

}  // namespace
}  // namespace girth::bind
