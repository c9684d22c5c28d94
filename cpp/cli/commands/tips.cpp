// girth tips: where the shape ends.
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/io/write_tips.h"
#include "girth/study/surface_changes.h"
#include "girth/study/tip_stability.h"
#include "girth/study/write_tip_trials.h"
#include "girth/tips.h"
#include "model/computing.h"
#include "model/loading.h"
#include "model/persistence.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace tips_command {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  Output output;
  unsigned threads{0};
  std::string persistence;
  bool stability{false};
  /// Of the trials, in mean edge lengths.
  std::vector<double> noise{study::TipTrialOptions{}.noise};
  bool json{false};
};

void printText(const std::string& model, const io::LoadedMesh& loaded, const Tips& tips,
               double persistence) {
  const std::string unit = unitSuffix(loaded.unit);
  std::printf("%s: %zu tip%s, %zu open arc%s%s\n", model.c_str(), tips.tips.size(),
              tips.tips.size() == 1 ? "" : "s", tips.arcs.size(), tips.arcs.size() == 1 ? "" : "s",
              persistenceText(persistence, loaded).c_str());
  if (!tips.tips.empty()) {
    std::printf("  %4s %12s %12s %12s %12s  %s\n", "tip", "jump", "area", "boundary", "to apex",
                "apex vertex");
  }
  for (std::size_t i = 0; i < tips.tips.size(); ++i) {
    const Tip& tip = tips.tips[i];
    std::printf("  %4zu %12s %12s %12s %12s  %s\n", i + 1, readable(tip.jump).c_str(),
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
      if (!trial.found[i]) lost += (lost.empty() ? "tip " : ", ") + std::to_string(i + 1);
    }
    std::printf("  %-34s %5u %6u  %s\n", change.c_str(), trial.tips, trial.arcs,
                tips.tips.empty() ? "-"
                : lost.empty()    ? "none"
                                  : lost.c_str());
  }
}

int run(const Options& options) {
  const std::string extension = options.output.ending();
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const SurfaceMesh& mesh = loaded.value().mesh;
  const auto persistence = persistenceOf(options.persistence, loaded.value());
  if (!persistence) return reportError("", persistence.error());
  const auto found = computeTips(options.model, mesh, persistence.value(), options.threads);
  if (!found) return reportError(options.model, found.error());
  const Tips& tips = found.value().tips;

  std::vector<study::TipTrial> trials;
  if (options.stability) {
    ProgressLine progress(options.model);
    study::TipTrialOptions trial;
    trial.persistence = persistence.value();
    trial.noise = options.noise;
    auto tried = study::tipTrials(mesh, tips.tips, trial, watched(options.threads, progress));
    if (!tried) return reportError(options.model, tried.error());
    trials = std::move(tried).value();
  }

  const auto json = [&] {
    return io::tipsJson(loaded.value(), tips, options.model, study::tipTrialsJson(trials),
                        persistence.value());
  };
  if (options.output.isWanted()) {
    if (auto error = writeOutput(
            options.output, extension == ".json" ? json() : io::tipsObj(loaded.value(), tips))) {
      return reportError(options.output.path, *error);
    }
  }
  if (options.json) {
    std::fputs(json().c_str(), stdout);
  } else if (hasSummary()) {
    printText(options.model, loaded.value(), tips, persistence.value());
    if (options.stability) printTrials(tips, trials);
  }
  return 0;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  addOutputOptions(table, options->output, {".json", ".obj"},
                   "Write the tips: .json, or .obj (their contours)");
  table.add("--stability", options->stability,
            "Also find the tips with each triangle cut into four, and with noise of 5, 10 and 25% "
            "of the mean edge length, and print which are found again; takes about twelve times as "
            "long");
  table
      .add("--noise EDGES,...", options->noise,
           "Other amounts of noise, in mean edge lengths, as in 0.5,1")
      .separated()
      .range(0, study::kMostNoise)
      .needs("--stability");
  addPersistenceOption(table, options->persistence);
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth tips hand.glb -o tips.json", "Where the shape ends, each with its contour.");
  table.example("girth tips hand.glb --stability",
                "And which are found again in finer triangles and under noise.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace tips_command

const Command kTips{"tips", "Find where the shape ends", tips_command::add};

}  // namespace girth::cli
