// girth study robustness: the paper's Figures 7, 8 and 9.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/study/robustness.h"
#include "girth/study/write_robustness.h"
#include "model/loading.h"
#include "process/files.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace {

struct Options {
  std::string model;
  std::vector<std::string> poses;
  study::RobustnessOptions study;
  /// Empty: only the table on standard output.
  std::string output;
  unsigned threads{0};
  bool json{false};
};

std::string cell(const std::optional<double>& value, const char* format, double factor = 1) {
  if (!value || std::isnan(*value)) return "-";
  char text[32];
  std::snprintf(text, sizeof(text), format, factor * *value);
  return text;
}

void print(const std::string& model, const std::vector<study::RobustnessRow>& rows) {
  std::printf("%s: how far the girth moves, as distributions (equation 1)\n", model.c_str());
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
  const std::string extension = extensionOf(options.output);
  if (!options.output.empty()) {
    if (auto error = checkOutput(options.output, {".csv", ".json"})) {
      return reportError(options.output, *error);
    }
  }
  const auto model = readSurface(options.model);
  if (!model) return reportError(options.model, model.error());
  std::vector<study::NamedSurface> poses;
  for (const std::string& path : options.poses) {
    auto pose = readSurface(path);
    if (!pose) return reportError(path, pose.error());
    poses.push_back({std::filesystem::path(path).filename().string(), std::move(pose).value()});
  }
  std::optional<Result<std::vector<study::RobustnessRow>>> rows;
  {
    ProgressLine progress(options.model);
    const ExecutionContext context = watched(options.threads, progress);
    rows = study::robustnessStudy(model.value(), poses, options.study, context);
  }
  if (!*rows) return reportError(options.model, rows->error());
  const auto json = [&] { return study::robustnessJson(rows->value(), options.model); };
  if (!options.output.empty()) {
    const std::string content = extension == ".csv" ? study::robustnessCsv(rows->value()) : json();
    if (auto error = writeFile(options.output, content)) {
      return reportError(options.output, *error);
    }
  }
  if (options.json) {
    std::fputs(json().c_str(), stdout);
  } else {
    print(options.model, rows->value());
  }
  return 0;
}

Run add(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  const auto range = CLI::Range(std::uint32_t{4}, kMostFaces);
  app.add_option("MODEL", options->model, "The model to change")->required();
  app.add_option("--poses", options->poses, "The same thing in other poses");
  app.add_option("--faces", options->study.faces,
                 "Triangles of the even mesh that is changed; 10000 by default")
      ->check(range);
  app.add_option("--sizes", options->study.sizes,
                 "Triangles to remesh the model to, N,N,...; 2000 to 50000 by default")
      ->delimiter(',')
      ->check(range);
  app.add_option("--stretch", options->study.stretch,
                 "How much longer uneven triangles are in one direction; 4 by default")
      ->check(CLI::Range(1.0, 100.0));
  app.add_option("--seed", options->study.seed, "Of the noise; 1 by default");
  app.add_option("-o,--output", options->output, "Write the table: .csv or .json");
  addThreadsOption(app, options->threads);
  app.add_flag("--json", options->json, "Print the table as JSON");
  return [options] { return run(*options); };
}

}  // namespace

const Command kStudyRobustness{
    "robustness", "How little the girth changes with a surface's triangles, noise and pose", add};

}  // namespace girth::cli
