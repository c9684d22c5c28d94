// girth necks: where a surface is locally narrowest.
#include "girth/necks.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/io/write_necks.h"
#include "model/computing.h"
#include "model/loading.h"
#include "process/hand_over.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace necks_command {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  Output output;
  unsigned threads{0};
  /// As typed, with or without a unit. Empty: 0.
  std::string minProminence;
  bool json{false};
};

void printText(const std::string& model, const io::LoadedMesh& loaded, const Necks& necks) {
  const std::size_t count = necks.necks.size();
  std::printf("%s: %s neck%s\n", model.c_str(), count == 0 ? "no" : std::to_string(count).c_str(),
              count == 1 ? "" : "s");
  if (count == 0) return;
  std::printf("  %4s %12s %12s %12s %12s  %s\n", "neck", "length", "prominence", "area", "width",
              "centre");
  for (std::size_t i = 0; i < count; ++i) {
    const Neck& neck = necks.necks[i];
    std::printf("  %4zu %12s %12s %12s %12s  %s %s %s%s\n", i + 1, readable(neck.length).c_str(),
                std::isfinite(neck.prominence) ? readable(neck.prominence).c_str() : "-",
                readable(neck.area).c_str(), readable(neck.width).c_str(),
                readable(neck.centre.x).c_str(), readable(neck.centre.y).c_str(),
                readable(neck.centre.z).c_str(),
                neck.measuresGirth ? "" : "  (beside a shorter loop)");
  }
  printUnits(loaded.unit);
}

Result<std::string> contentFor(const std::string& ending, const io::LoadedMesh& loaded,
                               const Necks& necks, const std::string& model) {
  if (ending == ".csv") return io::necksCsv(loaded, necks);
  if (ending == ".obj") return io::necksObj(loaded, necks);
  if (ending == ".glb") return io::necksGlb(loaded, necks);
  return io::necksJson(loaded, necks, model);
}

int run(const Options& options) {
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  NeckOptions wanted;
  if (const auto error =
          readLength(options.minProminence, loaded.value().unit, wanted.minProminence)) {
    return reportError(options.model, *error);
  }
  const SurfaceMesh& mesh = loaded.value().mesh;
  const auto girth = computeGirth(options.model, mesh, 0, options.threads);
  if (!girth) return reportError(options.model, girth.error());
  const auto necks = [&] {
    ProgressLine progress(options.model);
    return findNecks(mesh, girth.value().values, wanted, watched(options.threads, progress));
  }();
  if (!necks) return reportError(options.model, necks.error());
  if (necks.value().unresolved > 0) {
    printNote(options.model, std::to_string(necks.value().unresolved) +
                                 " vertices have loops that could not be followed");
  }
  return handOver(
      options.output, options.json,
      [&](const std::string& ending) {
        return contentFor(ending, loaded.value(), necks.value(), options.model);
      },
      [&] { return io::necksJson(loaded.value(), necks.value(), options.model); },
      [&] { printText(options.model, loaded.value(), necks.value()); });
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  addLengthOption(table, "--min-prominence LENGTH", options->minProminence,
                  "Only necks from which the girth must rise by this to reach a narrower one, as "
                  "in 2mm; 0 by default");
  addOutputOptions(table, options->output, {".json", ".csv", ".obj", ".glb"},
                   "Write the necks: .json, .csv (a row for each), .obj or .glb (closed lines)");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth necks vessel.stl --unit mm", "Where it is narrowest, and how narrow.");
  table.example("girth necks model.glb --min-prominence 2mm -o necks.glb",
                "The clear ones, as lines to look at.");
  table.note("Prominence",
             "How far the girth rises on the best way over the surface to a narrower neck: small "
             "for a dent of noise, large for a waist between two bodies. A dash: there is no "
             "narrower neck to reach.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace necks_command

const Command kNecks{"necks", "Find where a surface is locally narrowest", necks_command::add};

}  // namespace girth::cli
