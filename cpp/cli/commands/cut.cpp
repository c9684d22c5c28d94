// girth cut: the surface taken apart along loops.
#include "girth/cut_surface.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/girth_solver.h"
#include "girth/io/write_cut.h"
#include "girth/necks.h"
#include "model/computing.h"
#include "model/loading.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  Output output;
  unsigned threads{0};
  /// In the file's numbering, from 0: along the loop there.
  std::optional<std::int64_t> vertex;
  /// From 1, as `girth necks` prints it.
  std::optional<std::int64_t> neck;
  bool allNecks{false};
  /// As typed, with or without a unit. Empty: 0.
  std::string minProminence;
  bool cap{false};
  bool json{false};
};

/// The necks that are cut along.
Result<std::vector<SurfaceCurve>> neckCurves(const Options& options, const io::LoadedMesh& loaded) {
  NeckOptions wanted;
  if (const auto error = readLength(options.minProminence, loaded.unit, wanted.minProminence)) {
    return *error;
  }
  const auto girth = computeGirth(options.model, loaded.mesh, 0, options.threads);
  if (!girth) return girth.error();
  auto found = [&] {
    ProgressLine progress(options.model);
    return findNecks(loaded.mesh, girth.value().values, wanted, watched(options.threads, progress));
  }();
  if (!found) return found.error();
  const std::vector<Neck>& necks = found.value().necks;
  std::vector<SurfaceCurve> curves;
  if (!options.neck) {
    for (const Neck& neck : necks) curves.push_back(neck.points);
    return curves;
  }
  if (*options.neck < 1 || *options.neck > static_cast<std::int64_t>(necks.size())) {
    return usageError("there is no neck " + std::to_string(*options.neck),
                      necks.empty() ? "the model has none; name a vertex, whose loop is cut along"
                                    : "necks are numbered from 1 to " +
                                          std::to_string(necks.size()) + ", as girth necks lists");
  }
  curves.push_back(necks[static_cast<std::size_t>(*options.neck - 1)].points);
  return curves;
}

Result<std::vector<SurfaceCurve>> curvesOf(const Options& options, const io::LoadedMesh& loaded) {
  if (!options.vertex) return neckCurves(options, loaded);
  const Result<Vertex> vertex = surfaceVertex(loaded, *options.vertex);
  if (!vertex) return vertex.error();
  auto loop = GirthSolver(loaded.mesh).loop(vertex.value());
  if (!loop) return loop.error();
  if (loop.value().kind != LoopKind::Loop) {
    Error error = makeError(ErrorCode::InvalidOption, *options.vertex,
                            "no loop goes round at vertex " + std::to_string(*options.vertex));
    error.hint = "choose a vertex where girth loop has the kind loop";
    return error;
  }
  return std::vector<SurfaceCurve>{std::move(loop).value().points};
}

void printText(const Options& options, const io::LoadedMesh& loaded, std::size_t curves,
               const io::CutModel& model) {
  const std::size_t count = model.parts.size();
  std::printf("%s: cut along %zu loop%s: %zu part%s\n", options.model.c_str(), curves,
              curves == 1 ? "" : "s", count, count == 1 ? "" : "s");
  std::printf("  %4s %12s %12s %6s %10s\n", "part", "area", "faces", "genus", "boundaries");
  for (std::size_t i = 0; i < count; ++i) {
    const SurfaceMesh& mesh = model.parts[i].mesh;
    std::printf("  %4zu %12s %12u %6u %10u\n", i + 1, readable(mesh.area()).c_str(),
                mesh.faceCount(), mesh.genus(0), mesh.boundaryCount(0));
  }
  printUnits(loaded.unit);
}

Result<std::string> contentFor(const std::string& ending, const io::LoadedMesh& loaded,
                               const io::CutModel& model, const std::string& file) {
  if (ending == ".glb") return io::cutGlb(loaded, model);
  if (ending == ".obj") return io::cutObj(model);
  if (ending == ".csv") return io::cutCsv(loaded, model);
  return io::cutJson(loaded, model, file);
}

int run(const Options& options) {
  if (!options.vertex && !options.neck && !options.allNecks) {
    return reportError("", usageError("no loop is named",
                                      "name a vertex, a neck with --neck, or all with --necks"));
  }
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const auto curves = curvesOf(options, loaded.value());
  if (!curves) return reportError(options.model, curves.error());
  const auto cut = cutSurface(loaded.value().mesh, curves.value(), {options.cap});
  if (!cut) return reportError(options.model, cut.error());
  const io::CutModel model = io::cutModel(cut.value());
  if (options.output.isWanted()) {
    if (auto error = writeResult(options.output, contentFor(options.output.ending(), loaded.value(),
                                                            model, options.model))) {
      return reportError(options.output.path, *error);
    }
  }
  if (options.json) {
    std::fputs(io::cutJson(loaded.value(), model, options.model).c_str(), stdout);
  } else if (hasSummary()) {
    printText(options, loaded.value(), curves.value().size(), model);
  }
  return 0;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  table.add("VERTEX", options->vertex,
            "Cut along the loop at this vertex, numbered as in the file from 0");
  table
      .add("--neck N", options->neck, "Cut along one neck, numbered from 1 as girth necks lists it")
      .excludes("VERTEX");
  table.add("--necks", options->allNecks, "Cut along all necks").excludes("VERTEX");
  addLengthOption(table, "--min-prominence LENGTH", options->minProminence,
                  "Of the necks only those of at least this prominence, as in 2mm; 0 by default");
  table.add("--cap", options->cap, "Close the rims that cutting makes");
  addOutputOptions(table, options->output, {".glb", ".obj", ".json", ".csv"},
                   "Write the parts: .glb (a node for each), .obj (an object for each), .json "
                   "(what they measure), .csv (the part of each face)");
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth cut figure.stl --neck 1 --cap -o parts.glb",
                "In two at its clearest neck, both closed.");
  table.example("girth cut model.glb --necks --min-prominence 5mm -o segments.csv",
                "The parts of a body, as a label for each face.");
  return [options] { return run(*options); };
}

}  // namespace

const Command kCut{"cut", "Take a surface apart along loops and necks", add};

}  // namespace girth::cli
