#include "commands/igf/content.h"

#include <optional>
#include <utility>

#include "commands/common_options.h"
#include "girth/io/write_barcodes.h"
#include "girth/io/write_field.h"
#include "girth/tips.h"
#include "model/loading.h"
#include "process/interrupt.h"

namespace girth::cli::igf_command {

Result<std::vector<Vertex>> basesOf(const io::LoadedMesh& loaded, const Options& options) {
  std::vector<Vertex> bases;
  for (const std::uint32_t number : options.loops) {
    const auto vertex = surfaceVertex(loaded, number);
    if (!vertex) return vertex.error();
    bases.push_back(vertex.value());
  }
  return bases;
}

namespace {

/// The surface with its values, loops and tips.
Result<std::string> figureContent(const Work& work, std::span<const io::VertexField> fields,
                                  const Options& options) {
  const io::LoadedMesh& loaded = work.loaded;
  const auto bases = basesOf(loaded, options);
  if (!bases) return bases.error();
  const ExecutionContext context{options.threads, &catchInterrupts(), {}};
  GirthSolver solver(loaded.mesh);
  solver.setPersistence(work.persistence);
  std::vector<GirthLoop> loops;
  for (const Vertex base : bases.value()) {
    auto loop = solver.loop(base, context);
    if (!loop) return loop.error();
    loops.push_back(std::move(loop).value());
  }
  std::optional<Tips> tips;
  if (options.tips) {
    auto found = findTips(loaded.mesh, fields[0].values, context);
    if (!found) return found.error();
    tips = std::move(found).value();
  }
  if (auto error = io::checkFields(loaded, fields)) return *std::move(error);
  return io::fieldGlb(loaded, fields, std::nullopt, {loops, tips ? &*tips : nullptr});
}

}  // namespace

Result<std::string> contentFor(const Work& work, const GirthField& girth, const Options& options) {
  std::vector<io::VertexField> fields{
      io::girthVertexField(girth, options.method, work.loaded.unit)};
  fields[0].method = particulars(options, work);
  std::vector<double> states;
  // NumPy's files hold one field.
  if (work.refined != nullptr && options.output.ending() != ".npy") {
    for (const GirthState state : work.refined->states)
      states.push_back(static_cast<double>(state));
    fields.push_back(io::girthStateField(states, fields[0].method));
  }
  if (options.output.ending() == ".glb") return figureContent(work, fields, options);
  return io::fieldFile(work.loaded, fields, options.output.ending().substr(1), work.model,
                       columnsOf(options.positions));
}

std::string barcodesFor(const Work& work, std::span<const Barcode> barcodes,
                        const Options& options) {
  const std::string ending = options.barcodes.ending();
  if (ending == ".csv") return io::barcodesCsv(work.loaded, barcodes);
  if (ending == ".npy") return io::barcodesNpy(work.loaded, barcodes);
  return io::barcodesJson(work.loaded, barcodes, work.model);
}

}  // namespace girth::cli::igf_command
