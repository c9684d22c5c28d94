#include "compute.h"

#include <cstdio>

#include "progress_line.h"

namespace girth::cli {
namespace {

Error cancelled() { return makeError(ErrorCode::Cancelled, -1, "stopped before it was finished"); }

/// A remark that is no error.
void remark(const std::string& model, const std::string& text) {
  std::fprintf(stderr, "girth: %s: note: %s\n", model.c_str(), text.c_str());
}

}  // namespace

Result<GirthField> computeGirth(const std::string& model, const SurfaceMesh& mesh, unsigned threads,
                                const std::atomic<bool>& interrupted) {
  ExecutionContext context;
  context.threads = threads;
  context.cancel = &interrupted;
  ProgressLine progress(model);
  context.onProgress = [&](double fraction) { progress.show(fraction); };
  GirthField field = girthField(mesh, GirthMethod::Exact, context);
  if (!field.complete()) return cancelled();
  return field;
}

Result<ShapeDiameterField> computeDiameter(const std::string& model, const SurfaceMesh& mesh,
                                           const ShapeDiameterOptions& options, unsigned threads,
                                           const std::atomic<bool>& interrupted) {
  ExecutionContext context;
  context.threads = threads;
  context.cancel = &interrupted;
  auto field = shapeDiameter(mesh, options, context);
  if (!field) return field;
  if (!field.value().complete) return cancelled();
  if (field.value().insideOut) {
    remark(model,
           "the surface is inside out: its faces look inwards, and thickness is measured outside; "
           "turn the faces over");
  }
  if (field.value().withoutValue > 0) {
    remark(model, std::to_string(field.value().withoutValue) + " of " +
                      std::to_string(mesh.vertexCount()) +
                      " vertices have no thickness: no ray from them meets a wall from inside");
  }
  return field;
}

}  // namespace girth::cli
