#include "commands/igf/compute.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "girth/study/naive_girth.h"
#include "girth/transfer.h"
#include "model/computing.h"
#include "process/files.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli::igf_command {

namespace {

/// The function to compute, but for vertices whose values are known.
VertexFunction<GirthValue> withKnown(const GirthField& known,
                                     const VertexFunction<GirthValue>& function) {
  return {[&known, function](const ExecutionContext& context) -> VertexEvaluator<GirthValue> {
    return [&known, evaluate = function.evaluator(context)](Vertex v) -> Result<GirthValue> {
      if (!std::isnan(known.values[v])) return GirthValue{known.values[v], known.kinds[v]};
      return evaluate(v);
    };
  }};
}

}  // namespace

Result<GirthField> computeAll(const std::string& model, const SurfaceMesh& mesh,
                              const PartialField& partial, const Options& options,
                              double persistence) {
  std::optional<GirthField> known;
  if (options.resume && isFile(partial.path())) {
    auto read = partial.read();
    if (!read) return read.error();
    known = std::move(read).value();
    printNote(model, "going on from " + std::to_string(known->computed) + " of " +
                         std::to_string(mesh.vertexCount()) + " vertices");
  }
  if (!options.naive && options.method == GirthMethod::Exact) {
    noteLargeSurface(
        model, mesh,
        std::string(kFewerFaces) + (persistence > 0 ? "" : ", and --method refined minutes"));
  }
  ProgressLine progress(model);
  const ExecutionContext context = watched(options.threads, progress);
  const GirthOptions girth{options.method, persistence};
  if (!known) {
    return options.naive ? study::naiveGirthField(mesh, context) : girthField(mesh, girth, context);
  }
  const auto function =
      options.naive ? study::naiveGirthFunction(mesh) : girthFunction(mesh, girth);
  return girthFieldOf(evaluateAll(mesh, withKnown(*known, function), context));
}

Result<RefinedGirth> computeRefined(const std::string& model, const SurfaceMesh& mesh,
                                    const Options& options) {
  ProgressLine progress(model);
  RefinedOptions refined;
  refined.audit = options.audit;
  return refinedGirth(mesh, refined, watched(options.threads, progress));
}

GirthField girthOf(std::span<const Barcode> barcodes, double persistence) {
  VertexValues<GirthValue> girth;
  for (const Barcode& barcode : barcodes) girth.values.push_back(barcode.girth(persistence));
  girth.computed = barcodes.size();
  return girthFieldOf(girth);
}

GirthField fieldOnOriginal(const GirthField& field, const SurfaceMesh& remeshed,
                           const SurfaceMesh& original) {
  const std::vector<SurfacePoint> places = nearestPoints(remeshed, original);
  GirthField carried;
  carried.values = carriedBack(remeshed, field.values, original, places);
  for (const Index v : nearestVertices(remeshed, places)) carried.kinds.push_back(field.kinds[v]);
  carried.computed =
      static_cast<std::size_t>(std::count_if(carried.values.begin(), carried.values.end(),
                                             [](double value) { return !std::isnan(value); }));
  carried.statistics = field.statistics;
  return carried;
}

}  // namespace girth::cli::igf_command
