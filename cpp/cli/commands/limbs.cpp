// girth limbs: how long fingers, arms and legs are, and how thick all along.
#include "girth/limbs.h"

#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "commands/common_options.h"
#include "commands/measure.h"
#include "commands/table.h"
#include "girth/io/write_limbs.h"
#include "girth/tips.h"
#include "model/computing.h"
#include "model/persistence.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace limbs_command {
namespace {

struct Options : MeasuringOptions {
  std::string persistence;
  unsigned stations{LimbOptions{}.stations};
  bool profiles{false};
};

struct FoundLimbs {
  Limbs limbs;
  double persistence;
};

void printText(const std::string& model, const io::LoadedMesh& loaded, const FoundLimbs& found) {
  const Limbs& limbs = found.limbs;
  const std::size_t count = limbs.limbs.size(), none = limbs.tipsWithoutLimb.size();
  std::printf("%s: %zu limb%s", model.c_str(), count, count == 1 ? "" : "s");
  if (none > 0)
    std::printf(", %zu tip%s that end%s none", none, none == 1 ? "" : "s", none == 1 ? "s" : "");
  std::printf("%s\n", persistenceText(found.persistence, loaded).c_str());
  if (count == 0) return;
  std::printf("  %4s %12s %12s %12s %12s %12s  %-9s %s\n", "limb", "length", "narrowest", "median",
              "middle", "base", "end", "apex vertex");
  for (std::size_t i = 0; i < count; ++i) {
    const Limb& limb = limbs.limbs[i];
    std::printf("  %4zu %12s %12s %12s %12s %12s  %-9s %s\n", i, readable(limb.length).c_str(),
                readableOrDash(limb.narrowest).c_str(), readableOrDash(limb.median).c_str(),
                readableOrDash(limb.middle).c_str(), readableOrDash(limb.base).c_str(),
                std::string(toString(limb.end)).c_str(), numberInFile(loaded, limb.apex).c_str());
  }
  printUnits(loaded.unit);
}

Result<FoundLimbs> compute(const Options& options, const io::LoadedMesh& loaded) {
  if (options.profiles && options.output.ending() != ".csv") {
    return usageError("--profiles needs a table",
                      "write one: -o profiles.csv; JSON has the profiles anyway");
  }
  const auto persistence = persistenceOf(options.persistence, loaded);
  if (!persistence) return persistence.error();
  const auto found = computeTips(options.model, loaded.mesh, persistence.value(), options.threads);
  if (!found) return found.error();
  ProgressLine progress(options.model);
  auto limbs = findLimbs(loaded.mesh, found.value().girth.values, found.value().tips.tips,
                         {options.stations}, watched(options.threads, progress));
  if (!limbs) return limbs.error();
  return FoundLimbs{std::move(limbs).value(), persistence.value()};
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  const Writers<FoundLimbs> writers{
      {{".csv",
        [options](const io::LoadedMesh& loaded, const FoundLimbs& found) {
          return options->profiles ? io::limbProfilesCsv(loaded, found.limbs)
                                   : io::limbsCsv(loaded, found.limbs);
        }}},
      [options](const io::LoadedMesh& loaded, const FoundLimbs& found) {
        return io::limbsJson(loaded, found.limbs, options->model, found.persistence);
      },
      [options](const io::LoadedMesh& loaded, const FoundLimbs& found) {
        printText(options->model, loaded, found);
      }};
  table.add("MODEL", options->model, "The model to read").required();
  addOutputOptions(table, options->output, writers.endings(),
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
                "The girth along each finger, for a spreadsheet.");
  return [options, writers] {
    return measure(
        *options, [&](const io::LoadedMesh& loaded) { return compute(*options, loaded); }, writers);
  };
}

}  // namespace
}  // namespace limbs_command

const Command kLimbs{"limbs", "Measure limbs: fingers, arms, legs", limbs_command::add};

}  // namespace girth::cli
