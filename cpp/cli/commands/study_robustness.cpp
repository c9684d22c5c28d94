// girth study robustness: the paper's Figures 7, 8 and 9.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands/common_options.h"
#include "commands/table.h"
#include "files/path_of.h"
#include "girth/study/robustness.h"
#include "girth/study/write_robustness.h"
#include "model/loading.h"
#include "model/persistence.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace study_robustness_command {
namespace {

constexpr std::uint32_t kMostPlaces = 1'000;

struct Options {
  std::string model;
  /// Preparation of the model and its poses.
  ModelOptions preparing;
  std::vector<std::string> poses;
  study::RobustnessOptions study;
  Output output;
  unsigned threads{0};
  bool json{false};
};

std::string cell(const std::optional<double>& value, const char* format, double factor = 1) {
  if (!value || std::isnan(*value)) return "-";
  char text[32];
  std::snprintf(text, sizeof(text), format, factor * *value);
  return text;
}

void print(const std::string& model, const std::vector<study::RobustnessRow>& rows,
           double persistence) {
  std::printf(
      "%s: how far the girth moves, as distributions (equation 1)%s\n", model.c_str(),
      persistence > 0 ? (", persistence " + readable(100 * persistence) + "%").c_str() : "");
  std::printf("  %-6s %-34s %7s %10s %10s %10s\n", "figure", "change", "faces", "difference",
              "the paper", "unchanged");
  for (const study::RobustnessRow& row : rows) {
    std::printf("  %-6s %-34s %7u %10s %10s %10s%s%s\n", row.figure.c_str(), row.change.c_str(),
                row.faces, cell(row.difference, "%.1e").c_str(), cell(row.paper, "%.1e").c_str(),
                cell(row.unchanged, "%.1f%%", 100).c_str(), row.note.empty() ? "" : "  ",
                row.note.c_str());
  }
  std::printf(
      "  figure 7: against the model as it is, the paper's worst; others: against it with "
      "even triangles\n");
}

int run(const Options& options) {
  const std::string extension = options.output.ending();
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto model = loadModel(options.model, options.preparing);
  if (!model) return reportError(options.model, model.error());
  std::vector<study::NamedSurface> poses;
  for (const std::string& path : options.poses) {
    auto pose = loadModel(path, options.preparing);
    if (!pose) return reportError(path, pose.error());
    poses.push_back({io::pathOf(path).filename().string(), std::move(pose).value().mesh});
  }
  std::optional<Result<std::vector<study::RobustnessRow>>> rows;
  {
    ProgressLine progress(options.model);
    const ExecutionContext context = watched(options.threads, progress);
    rows = study::robustnessStudy(model.value().mesh, poses, options.study, context);
  }
  if (!*rows) return reportError(options.model, rows->error());
  const auto json = [&] { return study::robustnessJson(rows->value(), options.model); };
  if (options.output.isWanted()) {
    const std::string content = extension == ".csv" ? study::robustnessCsv(rows->value()) : json();
    if (auto error = writeOutput(options.output, content)) {
      return reportError(options.output.path, *error);
    }
  }
  if (options.json) {
    std::fputs(json().c_str(), stdout);
  } else if (hasSummary()) {
    print(options.model, rows->value(), options.study.persistence);
  }
  return 0;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to change").required();
  table.add("--poses MODEL", options->poses, "Other poses of the model; several may follow")
      .greedy();
  table
      .add("--size N", options->study.faces,
           "Triangles of the even mesh that is changed; 10000 by default")
      .range(4, kMostFaces);
  table
      .add("--sizes N,N,...", options->study.sizes,
           "Triangles to remesh the model to; 2000 to 50000 by default")
      .separated()
      .range(4, kMostFaces);
  table
      .add("--stretch FACTOR", options->study.stretch,
           "Stretch of uneven triangles in one direction; 4 by default")
      .range(1, 100);
  table
      .add("--noise EDGES,...", options->study.noise,
           "Greatest displacement of vertices, in mean edge lengths; 0.25,0.5 by default")
      .separated()
      .range(0, study::kMostNoise);
  table.add("--seed N", options->study.seed, "Seed of the noise; 1 by default");
  table
      .add("--bridges N", options->study.bridges,
           "Number of places where parts are joined; 2 by default")
      .range(1, kMostPlaces);
  table
      .add("--handles N,...", options->study.tinyHandles,
           "Numbers of tiny handles to add, measured before and after their removal")
      .separated()
      .range(1, kMostPlaces);
  addPersistenceShareOption(table, options->study.persistence, "");
  addOutputOptions(table, options->output, {".csv", ".json"}, "Write the table: .csv or .json");
  addModelOptions(table, options->preparing);
  addThreadsOption(table, options->threads);
  table.add("--json", options->json, "Print the table as JSON");
  table.example("girth study robustness model.off --size 8000 --sizes 2000,5000",
                "Other triangles, noise, humps and topology.");
  table.example("girth study robustness horse0.off --poses horse5.off horse6.off",
                "The same with other poses.");
  table.example("girth study robustness scan.ply --noise 0.5,1,2 --persistence 2%",
                "The persistent girth, under noise of up to two edges.");
  table.example("girth study robustness model.off --bridges 5 --handles 1,5,20",
                "More changes of topology.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace study_robustness_command

const Command kStudyRobustness{
    "robustness", "How little the girth changes with a surface's triangles, noise and pose",
    study_robustness_command::add};

}  // namespace girth::cli
