// girth limbs: how long fingers, arms and legs are, and how thick all along.
#include "girth/limbs.h"

#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/io/write_limbs.h"
#include "girth/tips.h"
#include "model/computing.h"
#include "model/loading.h"
#include "model/persistence.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace limbs_command {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  Output output;
  unsigned threads{0};
  std::string persistence;
  unsigned stations{LimbOptions{}.stations};
  bool profiles{false};
  bool json{false};
};

void printText(const std::string& model, const io::LoadedMesh& loaded, const Limbs& limbs,
               double persistence) {
  const std::size_t count = limbs.limbs.size(), none = limbs.tipsWithoutLimb.size();
  std::printf("%s: %zu limb%s", model.c_str(), count, count == 1 ? "" : "s");
  if (none > 0)
    std::printf(", %zu tip%s that end%s none", none, none == 1 ? "" : "s", none == 1 ? "s" : "");
  std::printf("%s\n", persistenceText(persistence, loaded).c_str());
  if (count == 0) return;
  std::printf("  %4s %12s %12s %12s %12s  %-9s %s\n", "limb", "length", "narrowest", "median",
              "base", "end", "apex vertex");
  for (std::size_t i = 0; i < count; ++i) {
    const Limb& limb = limbs.limbs[i];
    std::printf("  %4zu %12s %12s %12s %12s  %-9s %s\n", i + 1, readable(limb.length).c_str(),
                readableOrDash(limb.narrowest).c_str(), readableOrDash(limb.median).c_str(),
                readableOrDash(limb.base).c_str(), std::string(toString(limb.end)).c_str(),
                numberInFile(loaded, limb.apex).c_str());
  }
  printUnits(loaded.unit);
}

int run(const Options& options) {
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const std::string ending = options.output.ending();
  if (options.profiles && ending != ".csv") {
    return reportError("", usageError("--profiles is for a table",
                                      "write one: -o profiles.csv; JSON has the profiles anyway"));
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const SurfaceMesh& mesh = loaded.value().mesh;
  const auto persistence = persistenceOf(options.persistence, loaded.value());
  if (!persistence) return reportError("", persistence.error());
  const auto found = computeTips(options.model, mesh, persistence.value(), options.threads);
  if (!found) return reportError(options.model, found.error());
  const auto limbs = [&] {
    ProgressLine progress(options.model);
    return findLimbs(mesh, found.value().girth.values, found.value().tips.tips, {options.stations},
                     watched(options.threads, progress));
  }();
  if (!limbs) return reportError(options.model, limbs.error());

  const auto json = [&] {
    return io::limbsJson(loaded.value(), limbs.value(), options.model, persistence.value());
  };
  if (options.output.isWanted()) {
    const std::string content = ending == ".json" ? json()
                                : options.profiles
                                    ? io::limbProfilesCsv(loaded.value(), limbs.value())
                                    : io::limbsCsv(loaded.value(), limbs.value());
    if (auto error = writeOutput(options.output, content)) {
      return reportError(options.output.path, *error);
    }
  }
  if (options.json) {
    std::fputs(json().c_str(), stdout);
  } else if (hasSummary()) {
    printText(options.model, loaded.value(), limbs.value(), persistence.value());
  }
  return 0;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  addOutputOptions(table, options->output, {".json", ".csv"},
                   "Write the limbs: .json, with their profiles, or .csv, a row for each");
  table.add("--profiles", options->profiles,
            "Write the profiles as .csv: a row for each station of each limb");
  table
      .add("--stations N", options->stations,
           "Stations of each profile. Default: " + std::to_string(options->stations))
      .range(1, 10'000);
  addPersistenceOption(table, options->persistence);
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth limbs hand.glb", "Length and girth of each finger.");
  table.example("girth limbs hand.glb --profiles -o fingers.csv",
                "How thick they are all along, for a spreadsheet.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace limbs_command

const Command kLimbs{"limbs", "Measure what each tip ends: fingers, arms, legs",
                     limbs_command::add};

}  // namespace girth::cli
