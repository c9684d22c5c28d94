// girth igf: the girth at every vertex.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/girth_field.h"
#include "girth/io/write_field.h"
#include "girth/parallel.h"
#include "girth/study/naive_girth.h"
#include "girth/transfer.h"
#include "model/computing.h"
#include "model/loading.h"
#include "process/files.h"
#include "process/interrupt.h"
#include "process/progress_line.h"
#include "process/report.h"
#include "text/json_text.h"
#include "text/number_text.h"

namespace girth::cli {
namespace {

struct Options {
  std::vector<std::string> models;
  ModelOptions preparing;
  /// Empty: only a summary.
  std::string output;
  GirthMethod method{GirthMethod::Exact};
  /// By the study's naive method instead.
  bool naive{false};
  /// 0: on the surface as it is; otherwise on one remeshed to so many faces, and carried back.
  std::uint32_t faces{0};
  unsigned threads{0};
  bool json{false};
  bool stats{false};
};

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What the values are like, over the vertices that were computed.
struct Summary {
  double least{0}, median{0}, greatest{0};
  std::size_t computed{0}, loops{0}, antipodal{0}, unresolved{0};
};

Summary summarize(const GirthField& field) {
  Summary summary;
  std::vector<double> values;
  for (std::size_t v = 0; v < field.values.size(); ++v) {
    if (std::isnan(field.values[v])) continue;
    values.push_back(field.values[v]);
    switch (field.kinds[v]) {
      case LoopKind::Loop:
        ++summary.loops;
        break;
      case LoopKind::Antipodal:
        ++summary.antipodal;
        break;
      case LoopKind::Unresolved:
        ++summary.unresolved;
        break;
    }
  }
  summary.computed = values.size();
  if (values.empty()) return summary;
  std::sort(values.begin(), values.end());
  summary.least = values.front();
  summary.greatest = values.back();
  const std::size_t middle = values.size() / 2;
  summary.median =
      values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  return summary;
}

std::string methodText(const Options& options) {
  return options.naive ? "naive" : std::string(io::toString(options.method));
}

struct Timing {
  double reading{0}, computing{0};
};

unsigned threadsOf(const Options& options) { return threadCount({options.threads}); }

/// Time of one thread for one window that crossed a face; 0 where none were counted.
double nanosecondsPerWindow(const GirthField& field, const Options& options, const Timing& timing) {
  if (field.statistics.windowsCrossed == 0) return 0;
  return 1e9 * timing.computing * threadsOf(options) /
         static_cast<double>(field.statistics.windowsCrossed);
}

void printJson(const std::string& model, const io::LoadedMesh& loaded, const GirthField& field,
               const Options& options, const Timing& timing) {
  const Summary summary = summarize(field);
  const auto number = [&](double value) {
    return summary.computed > 0 ? io::formatNumber(value) : std::string("null");
  };
  std::string text = "{\"file\":" + io::jsonString(model) +
                     ",\"field\":\"igf\",\"method\":" + io::jsonString(methodText(options)) +
                     ",\"unit\":" + io::jsonString(loaded.unit) +
                     ",\"vertices\":" + std::to_string(field.values.size()) +
                     ",\"computed\":" + std::to_string(summary.computed) +
                     ",\"complete\":" + (field.complete() ? "true" : "false") +
                     ",\"min\":" + number(summary.least) + ",\"median\":" + number(summary.median) +
                     ",\"max\":" + number(summary.greatest) +
                     ",\"loop\":" + std::to_string(summary.loops) +
                     ",\"antipodal\":" + std::to_string(summary.antipodal) +
                     ",\"unresolved\":" + std::to_string(summary.unresolved) +
                     ",\"seconds\":" + readable(timing.computing);
  if (!options.output.empty()) text += ",\"output\":" + io::jsonString(options.output);
  if (options.stats) {
    text += ",\"readingSeconds\":" + readable(timing.reading) +
            ",\"sources\":" + std::to_string(field.statistics.sources) +
            ",\"windowsCreated\":" + std::to_string(field.statistics.windowsCreated) +
            ",\"windowsCrossed\":" + std::to_string(field.statistics.windowsCrossed) +
            ",\"peakBytes\":" + std::to_string(field.statistics.peakBytes) +
            ",\"nanosecondsPerWindow\":" + readable(nanosecondsPerWindow(field, options, timing));
  }
  std::fputs((text + "}\n").c_str(), stdout);
}

void printText(const std::string& model, const io::LoadedMesh& loaded, const GirthField& field,
               const Options& options, const Timing& timing) {
  const Summary summary = summarize(field);
  const std::string unit = unitSuffix(loaded.unit);
  std::printf("%s: %u faces, girth at %zu of %zu vertices in %s\n", model.c_str(),
              loaded.mesh.faceCount(), summary.computed, field.values.size(),
              readableTime(timing.computing).c_str());
  if (summary.computed > 0) {
    std::printf("  min %s, median %s, max %s%s\n", readable(summary.least).c_str(),
                readable(summary.median).c_str(), readable(summary.greatest).c_str(), unit.c_str());
    std::printf("  %zu loop, %zu antipodal\n", summary.loops, summary.antipodal);
    if (summary.unresolved > 0) {
      std::printf("  %zu unresolved: given up, the value is a lower bound\n", summary.unresolved);
    }
  }
  if (options.stats) {
    const unsigned threads = threadsOf(options);
    const SearchStatistics& cost = field.statistics;
    const double vertices = static_cast<double>(std::max<std::size_t>(1, summary.computed));
    std::printf("  %s method, %u thread%s, read in %s\n", methodText(options).c_str(), threads,
                threads == 1 ? "" : "s", readableTime(timing.reading).c_str());
    std::printf("  %s ms a vertex\n", readable(1000 * timing.computing / vertices).c_str());
    if (cost.sources == 0) return;  // only the exact method counts
    const double sources = static_cast<double>(cost.sources);
    std::printf(
        "  %zu windows created, %s a source; %zu crossed a face, %s a source\n",
        cost.windowsCreated, readable(static_cast<double>(cost.windowsCreated) / sources).c_str(),
        cost.windowsCrossed, readable(static_cast<double>(cost.windowsCrossed) / sources).c_str());
    std::printf("  %s ns a window and thread; at most %s MB a thread\n",
                readable(nanosecondsPerWindow(field, options, timing)).c_str(),
                readable(static_cast<double>(cost.peakBytes) / 1e6).c_str());
  }
}

Result<std::string> contentFor(const std::string& extension, const std::string& model,
                               const io::LoadedMesh& loaded, const GirthField& girth,
                               const Options& options) {
  io::VertexField field = io::girthVertexField(girth, options.method, loaded.unit);
  field.method = methodText(options);
  const std::span<const io::VertexField> fields(&field, 1);
  if (extension == ".csv") return io::fieldCsv(loaded, fields);
  if (extension == ".json") return io::fieldJson(loaded, fields, model);
  if (extension == ".npy") return io::fieldNpy(loaded, field);
  if (extension == ".glb") return io::fieldGlb(loaded, fields);
  return io::fieldPly(loaded, fields);
}

/// The field of a remeshed surface at the vertices of the original.
GirthField carriedBack(const GirthField& field, const SurfaceMesh& remeshed,
                       const SurfaceMesh& original) {
  // Where it is steeper, the girth jumps (web/docs/definitions.md, section 2).
  constexpr double kSteepest = 2;
  const std::vector<SurfacePoint> places = nearestPoints(remeshed, original);
  GirthField carried;
  carried.values = interpolated(remeshed, field.values, places, kSteepest);
  for (const Index v : nearestVertices(remeshed, places)) carried.kinds.push_back(field.kinds[v]);
  carried.computed =
      static_cast<std::size_t>(std::count_if(carried.values.begin(), carried.values.end(),
                                             [](double value) { return !std::isnan(value); }));
  carried.statistics = field.statistics;
  return carried;
}

int runOne(const std::string& model, const Options& options) {
  Timing timing;
  const auto readingStart = Clock::now();
  const auto loaded = loadModel(model, options.preparing);
  if (!loaded) return reportError(model, loaded.error());
  timing.reading = secondsSince(readingStart);

  const auto computingStart = Clock::now();
  std::optional<RemeshedSurface> remeshed;
  if (options.faces > 0) {
    auto result = remeshModel(model, loaded.value().mesh, {options.faces});
    if (!result) return reportError(model, result.error());
    remeshed.emplace(std::move(result).value());
  }
  GirthField field;
  {
    ProgressLine progress(model);
    const SurfaceMesh& mesh = remeshed ? remeshed->mesh : loaded.value().mesh;
    const ExecutionContext context = watched(options.threads, progress);
    field = options.naive ? study::naiveGirthField(mesh, context)
                          : girthField(mesh, options.method, context);
  }
  if (remeshed) field = carriedBack(field, remeshed->mesh, loaded.value().mesh);
  timing.computing = secondsSince(computingStart);

  if (!options.output.empty()) {
    const auto content =
        contentFor(extensionOf(options.output), model, loaded.value(), field, options);
    if (!content) return reportError(options.output, content.error());
    if (auto error = writeFile(options.output, content.value())) {
      return reportError(options.output, *error);
    }
  }
  if (options.json) {
    printJson(model, loaded.value(), field, options, timing);
  } else {
    printText(model, loaded.value(), field, options, timing);
  }
  if (field.complete()) return 0;
  Error error = makeError(ErrorCode::Cancelled, -1,
                          "stopped after " + std::to_string(field.computed) + " of " +
                              std::to_string(field.values.size()) + " vertices");
  error.hint = options.output.empty() ? "" : "partial results are in " + options.output;
  return reportError(model, error);
}

int run(const Options& options) {
  if (!options.output.empty()) {
    if (options.models.size() > 1) {
      return reportError(options.output, usageError("-o takes the values of one model only",
                                                    "call girth igf once for each model"));
    }
    if (auto error = checkOutput(options.output, {".csv", ".json", ".npy", ".ply", ".glb"})) {
      return reportError(options.output, *error);
    }
  }
  const std::atomic<bool>& interrupted = catchInterrupts();
  int exitCode = 0;
  for (const std::string& model : options.models) {
    if (interrupted) break;
    exitCode = std::max(exitCode, runOne(model, options));
  }
  return exitCode;
}

Run add(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("MODEL", options->models, "Models to read")->required();
  addModelOptions(app, options->preparing);
  app.add_option(
      "-o,--output", options->output,
      "Write the values: .csv, .json or .npy (the file's vertices), .ply or .glb (the surface)");
  app.add_option_function<std::string>(
         "--method",
         [options](const std::string& name) {
           options->naive = name == "naive";
           options->method = name == "ms" ? GirthMethod::Marched : GirthMethod::Exact;
         },
         "exact (the default), naive, the slow reference implementation, or ms, the fast-marching "
         "approximation")
      ->check(CLI::IsMember({"exact", "naive", "ms"}));
  addThreadsOption(app, options->threads);
  app.add_option("--faces", options->faces,
                 "Compute on the surface remeshed to so many faces, and carry the values back")
      ->check(CLI::Range(std::uint32_t{4}, kMostFaces));
  app.add_flag("--json", options->json, "Print the summary as one JSON object for each model");
  app.add_flag("--stats", options->stats, "Print what the computation took");
  return [options] { return run(*options); };
}

}  // namespace

const Command kIgf{"igf", "Compute the girth at every vertex", add};

}  // namespace girth::cli
