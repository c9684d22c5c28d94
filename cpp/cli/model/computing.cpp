#include "model/computing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "process/interrupt.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace {

Error cancelled() { return makeError(ErrorCode::Cancelled, -1, "stopped before it was finished"); }

}  // namespace

void noteLargeSurface(const std::string& model, const SurfaceMesh& mesh, std::string_view remedy) {
  // Two minutes on two cores, of a body with limbs.
  constexpr Index kMany = 100'000;
  if (mesh.faceCount() < kMany) return;
  printNote(model, "the exact girth of " + std::to_string(mesh.faceCount()) +
                       " triangles may take hours; " + std::string(remedy));
}

Result<GirthField> computeGirth(const std::string& model, const SurfaceMesh& mesh,
                                double persistence, unsigned threads, std::string_view remedy) {
  noteLargeSurface(model, mesh, remedy);
  ProgressLine progress(model);
  GirthField field =
      girthField(mesh, {GirthMethod::Exact, persistence}, watched(threads, progress));
  if (!field.complete()) return cancelled();
  return field;
}

Result<std::vector<Barcode>> computeBarcodes(const std::string& model, const SurfaceMesh& mesh,
                                             double persistence, unsigned threads) {
  BarcodeOptions options;
  if (persistence > 0) options.maxPersistence = persistence;
  ProgressLine progress(model);
  auto barcodes = evaluateAll(mesh, barcodeFunction(mesh, options), watched(threads, progress));
  if (!barcodes.complete()) return cancelled();
  return std::move(barcodes.values);
}

Result<GirthAndTips> computeTips(const std::string& model, const SurfaceMesh& mesh,
                                 double persistence, unsigned threads) {
  auto girth = computeGirth(model, mesh, persistence, threads);
  if (!girth) return girth.error();
  auto tips = findTips(mesh, girth.value().values, {0, &catchInterrupts(), {}});
  if (!tips) return tips.error();
  return GirthAndTips{std::move(girth).value(), std::move(tips).value()};
}

Result<FieldValues> computeField(const std::string& model, const SurfaceMesh& mesh,
                                 std::string_view name, const FieldOptions& options,
                                 unsigned threads) {
  auto field = [&] {
    ProgressLine progress(model);
    return fieldValues(mesh, name, options, watched(threads, progress));
  }();
  if (field && !field.value().note.empty()) printNote(model, field.value().note);
  return field;
}

Result<PrintCheck> computePrintCheck(const std::string& model, const SurfaceMesh& mesh,
                                     const PrintFields& fields, const PrintLimits& limits,
                                     unsigned threads) {
  ProgressLine progress(model);
  auto check = checkPrint(mesh, fields, limits, {}, watched(threads, progress));
  if (check && !check.value().complete) return cancelled();
  return check;
}

Result<std::optional<RemeshedSurface>> remeshModel(const std::string& model,
                                                   const SurfaceMesh& mesh,
                                                   const RemeshOptions& options) {
  // The number is met to within 2 %, so a second attempt is near enough.
  constexpr int kAttempts = 3;
  constexpr Index kFewest = 4;
  const bool isEven = options.method == RemeshMethod::Even;
  if (mesh.faceCount() <= options.faces && !isEven) return std::optional<RemeshedSurface>();
  const Index most = std::min(options.faces, mesh.faceCount());
  ProgressLine progress(model);
  const ExecutionContext context = watched(0, progress);
  RemeshOptions attempt = options;
  attempt.faces = std::max(most, kFewest);
  for (int i = 1;; ++i) {
    auto remeshed = remesh(mesh, attempt, context);
    if (!remeshed) return remeshed.error();
    const Index faces = remeshed.value().mesh.faceCount();
    const bool isWithin = faces <= most;
    if (!isWithin && i < kAttempts) {
      const double factor = 0.995 * static_cast<double>(most) / static_cast<double>(faces);
      attempt.faces = std::max(
          kFewest, static_cast<Index>(std::floor(factor * static_cast<double>(attempt.faces))));
      continue;
    }
    if (!isWithin) {
      printNote(model, "its shape needs " + std::to_string(faces) + " triangles, more than " +
                           std::to_string(most));
    }
    return std::optional<RemeshedSurface>(std::move(remeshed).value());
  }
}

}  // namespace girth::cli
