#include "model/computing.h"

#include <cstdio>

#include "process/progress_line.h"

namespace girth::cli {
namespace {

Error cancelled() { return makeError(ErrorCode::Cancelled, -1, "stopped before it was finished"); }

}  // namespace

Result<GirthField> computeGirth(const std::string& model, const SurfaceMesh& mesh,
                                unsigned threads) {
  ProgressLine progress(model);
  GirthField field = girthField(mesh, GirthMethod::Exact, watched(threads, progress));
  if (!field.complete()) return cancelled();
  return field;
}

Result<ShapeDiameterField> computeDiameter(const std::string& model, const SurfaceMesh& mesh,
                                           const ShapeDiameterOptions& options, unsigned threads) {
  auto field = [&] {
    ProgressLine progress(model);
    return shapeDiameter(mesh, options, watched(threads, progress));
  }();
  if (!field) return field;
  if (!field.value().complete) return cancelled();
  const std::string note =
      shapeDiameterNote(field.value().insideOut, field.value().withoutValue, mesh.vertexCount());
  if (!note.empty()) std::fprintf(stderr, "girth: %s: note: %s\n", model.c_str(), note.c_str());
  return field;
}

Result<RemeshedSurface> remeshModel(const std::string& model, const SurfaceMesh& mesh,
                                    const RemeshOptions& options) {
  ProgressLine progress(model);
  const ExecutionContext context = watched(0, progress);
  return remesh(mesh, options, context);
}

}  // namespace girth::cli
