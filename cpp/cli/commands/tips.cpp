// girth tips: where the shape ends.
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/common_options.h"
#include "commands/measure.h"
#include "commands/table.h"
#include "girth/io/write_tips.h"
#include "girth/study/surface_changes.h"
#include "girth/study/tip_stability.h"
#include "girth/study/write_tip_trials.h"
#include "girth/tips.h"
#include "model/computing.h"
#include "model/persistence.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace tips_command {
namespace {

struct Options : MeasuringOptions {
  std::string persistence;
  bool stability{false};
  /// Noise of the trials, in mean edge lengths.
  std::vector<double> noise{study::TipTrialOptions{}.noise};
};

struct FoundTips {
  Tips tips;
  double persistence;
  std::vector<study::TipTrial> trials;
};

void printText(const std::string& model, const io::LoadedMesh& loaded, const FoundTips& found) {
  const Tips& tips = found.tips;
  const std::string unit = unitSuffix(loaded.unit);
  std::printf("%s: %zu tip%s, %zu open arc%s%s\n", model.c_str(), tips.tips.size(),
              tips.tips.size() == 1 ? "" : "s", tips.arcs.size(), tips.arcs.size() == 1 ? "" : "s",
              persistenceText(found.persistence, loaded).c_str());
  if (!tips.tips.empty()) {
    std::printf("  %4s %12s %12s %12s %12s  %s\n", "tip", "jump", "area", "boundary", "to apex",
                "apex vertex");
  }
  for (std::size_t i = 0; i < tips.tips.size(); ++i) {
    const Tip& tip = tips.tips[i];
    std::printf("  %4zu %12s %12s %12s %12s  %s\n", i, readable(tip.jump).c_str(),
                readable(tip.area).c_str(), readable(tip.boundaryLength).c_str(),
                readable(tip.apexDistance).c_str(), numberInFile(loaded, tip.apex).c_str());
  }
  if (!tips.tips.empty()) printUnits(loaded.unit);
  if (!tips.arcs.empty()) {
    std::printf("  the open arcs cut no tip off; the longest has length %s%s\n",
                readable(tips.arcs[0].length).c_str(), unit.c_str());
  }
}

/// Which tips are found again after each change.
void printTrials(const Tips& tips, const std::vector<study::TipTrial>& trials) {
  std::printf("  %-34s %5s %6s  %s\n", "after a change of the surface", "tips", "arcs",
              "not found again");
  for (const study::TipTrial& trial : trials) {
    const std::string change = trial.noise
                                   ? "noise of " + readable(100 * *trial.noise) + "% of an edge"
                                   : std::string("each triangle cut into four");
    if (trial.failed) {
      std::printf("  %-34s %s\n", change.c_str(), trial.failed->message.c_str());
      continue;
    }
    std::string lost;
    for (std::size_t i = 0; i < trial.found.size(); ++i) {
      if (!trial.found[i]) lost += (lost.empty() ? "tip " : ", ") + std::to_string(i);
    }
    std::printf("  %-34s %5u %6u  %s\n", change.c_str(), trial.tips, trial.arcs,
                tips.tips.empty() ? "-"
                : lost.empty()    ? "none"
                                  : lost.c_str());
  }
}

Result<FoundTips> compute(const Options& options, const io::LoadedMesh& loaded) {
  const auto persistence = persistenceOf(options.persistence, loaded);
  if (!persistence) return persistence.error();
  auto tips = computeTips(options.model, loaded.mesh, persistence.value(), options.threads);
  if (!tips) return tips.error();
  FoundTips found{std::move(tips.value().tips), persistence.value(), {}};
  if (options.stability) {
    ProgressLine progress(options.model);
    study::TipTrialOptions trial;
    trial.persistence = found.persistence;
    trial.noise = options.noise;
    auto trials =
        study::tipTrials(loaded.mesh, found.tips.tips, trial, watched(options.threads, progress));
    if (!trials) return trials.error();
    found.trials = std::move(trials).value();
  }
  return found;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  const Writers<FoundTips> writers{
      {{".obj", [](const io::LoadedMesh& loaded,
                   const FoundTips& found) { return io::tipsObj(loaded, found.tips); }}},
      [options](const io::LoadedMesh& loaded, const FoundTips& found) {
        return io::tipsJson(loaded, found.tips, options->model, study::tipTrialsJson(found.trials),
                            found.persistence);
      },
      [options](const io::LoadedMesh& loaded, const FoundTips& found) {
        printText(options->model, loaded, found);
        if (options->stability) printTrials(found.tips, found.trials);
      }};
  table.add("MODEL", options->model, "The model to read").required();
  addOutputOptions(table, options->output, writers.endings(),
                   "Write the tips: .json, or .obj (their contours)");
  table.add("--stability", options->stability,
            "Also print which tips are found again with each triangle cut into four, and with "
            "noise of 5, 10 and 25% of the mean edge length; takes about twelve times as long");
  table
      .add("--noise EDGES,...", options->noise,
           "Other amounts of noise, in mean edge lengths, as in 0.5,1")
      .separated()
      .range(0, study::kMostNoise)
      .needs("--stability");
  addPersistenceOption(table, options->persistence);
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth tips hand.glb -o tips.json", "The tips of a hand, each with its contour.");
  table.example("girth tips hand.glb --stability",
                "The tips, and which are found again in finer triangles and under noise.");
  return [options, writers] {
    return measure(
        *options, [&](const io::LoadedMesh& loaded) { return compute(*options, loaded); }, writers);
  };
}

}  // namespace
}  // namespace tips_command

const Command kTips{"tips", "Find where the shape ends", tips_command::add};

}  // namespace girth::cli
