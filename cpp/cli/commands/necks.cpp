// girth necks: where a surface is locally narrowest.
#include "girth/necks.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "commands/common_options.h"
#include "commands/measure.h"
#include "commands/table.h"
#include "girth/io/write_necks.h"
#include "model/clear_necks.h"
#include "model/computing.h"
#include "process/report.h"

namespace girth::cli {
namespace necks_command {
namespace {

struct Options : MeasuringOptions {
  /// As typed, with or without a unit. Empty: the suggested one.
  std::string minProminence;
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
    std::printf("  %4zu %12s %12s %12s %12s  %s %s %s%s\n", i, readable(neck.length).c_str(),
                std::isfinite(neck.prominence) ? readable(neck.prominence).c_str() : "-",
                readable(neck.area).c_str(), readable(neck.width).c_str(),
                readable(neck.centre.x).c_str(), readable(neck.centre.y).c_str(),
                readable(neck.centre.z).c_str(),
                neck.measuresGirth ? "" : "  (beside a shorter loop)");
  }
  printUnits(loaded.unit);
}

Result<Necks> compute(const Options& options, const io::LoadedMesh& loaded) {
  const auto least = readProminence(options.minProminence, loaded.unit);
  if (!least) return least.error();
  const auto girth = computeGirth(options.model, loaded.mesh, 0, options.threads);
  if (!girth) return girth.error();
  auto necks =
      computeNecks(options.model, loaded, girth.value().values, least.value(), options.threads);
  if (necks && necks.value().unresolved > 0) {
    printNote(options.model, std::to_string(necks.value().unresolved) +
                                 " vertices have loops that could not be followed");
  }
  return necks;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  const Writers<Necks> writers{
      {{".csv", io::necksCsv}, {".obj", io::necksObj}, {".glb", io::necksGlb}},
      [options](const io::LoadedMesh& loaded, const Necks& necks) {
        return io::necksJson(loaded, necks, options->model);
      },
      [options](const io::LoadedMesh& loaded, const Necks& necks) {
        printText(options->model, loaded, necks);
      }};
  table.add("MODEL", options->model, "The model to read").required();
  addProminenceOption(table, options->minProminence,
                      "Only necks from which the girth must rise by this to reach a narrower one");
  addOutputOptions(table, options->output, writers.endings(),
                   "Write the necks: .json, .csv (a row for each), .obj or .glb (closed lines)");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth necks vessel.stl --unit mm",
                "The narrowest places, and how narrow they are.");
  table.example("girth necks model.glb --min-prominence 2mm -o necks.glb",
                "The clear necks, as lines.");
  table.note("Prominence",
             "How far the girth rises on the best way over the surface to a narrower neck: small "
             "for a dent of noise, large for a waist between two bodies. A dash: there is no "
             "narrower neck to reach.");
  return [options, writers] {
    return measure(
        *options, [&](const io::LoadedMesh& loaded) { return compute(*options, loaded); }, writers);
  };
}

}  // namespace
}  // namespace necks_command

const Command kNecks{"necks", "Find where a surface is locally narrowest", necks_command::add};

}  // namespace girth::cli
