// girth distance: distances between pairs of points, along the surface.
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/common_options.h"
#include "commands/measure.h"
#include "commands/table.h"
#include "girth/describe/distances.h"
#include "girth/io/result_csv.h"
#include "girth/io/result_json.h"
#include "model/typed_point.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace distance_command {
namespace {

/// Rows that are printed.
constexpr std::size_t kMostRows = 50;

struct Options : MeasuringOptions {
  std::string between;
  bool paths{false};
};

Result<DistancesOptions> pairsOf(const Options& options, const io::LoadedMesh& loaded) {
  const auto typed = readPointRows(options.between);
  if (!typed) return typed.error();
  DistancesOptions wanted{{}, options.paths};
  for (const std::vector<TypedPoint>& row : typed.value()) {
    if (row.size() != 2) {
      return usageError(
          options.between + " has a row of " + std::to_string(row.size()) + " points, not of two",
          "write the two points of a pair into a row, as in 12,88");
    }
    const auto points = surfacePoints(loaded, row, options.model, options.preparing);
    if (!points) return points.error();
    wanted.pairs.push_back({points.value()[0], points.value()[1]});
  }
  return wanted;
}

Result<Distances> compute(const Options& options, const io::LoadedMesh& loaded) {
  const auto wanted = pairsOf(options, loaded);
  if (!wanted) return wanted.error();
  ProgressLine progress(options.model);
  return findDistances(loaded.mesh, wanted.value(), watched(options.threads, progress));
}

void printText(const std::string& model, const io::LoadedMesh& loaded, const Distances& found) {
  const std::size_t count = found.distances.size();
  std::printf("%s: %zu distance%s\n", model.c_str(), count, count == 1 ? "" : "s");
  std::printf("  %7s %12s %12s\n", "pair", "length", "straight");
  for (std::size_t i = 0; i < count && i < kMostRows; ++i) {
    const Distance& distance = found.distances[i];
    std::printf("  %7zu %12s %12s\n", i, readable(distance.length).c_str(),
                readable(distance.straight).c_str());
  }
  if (count > kMostRows) {
    std::printf("  ... and %zu more, which -o writes\n", count - kMostRows);
  }
  printUnits(loaded.unit);
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  const Writers<Distances> writers{{{".csv", io::resultCsv<Distances>}},
                                   [options](const io::LoadedMesh& loaded, const Distances& found) {
                                     return io::resultJson(loaded, found, options->model);
                                   },
                                   [options](const io::LoadedMesh& loaded, const Distances& found) {
                                     printText(options->model, loaded, found);
                                   }};
  table.add("MODEL", options->model, "The model to read").required();
  table
      .add("--between FILE", options->between,
           "The pairs: a row of two points each, as in 12,88; points of faces as in 7:0.2,0.3,0.5")
      .required();
  table.add("--paths", options->paths, "With the points of each shortest path, in JSON");
  addOutputOptions(table, options->output, writers.endings(),
                   "Write the distances: .json or .csv (a row for each)");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth distance model.glb --between pairs.csv -o lengths.csv",
                "The distance along the surface between the points of each row.");
  table.example("girth distance model.glb --between pairs.csv --paths --json",
                "The distances with their shortest paths.");
  table.note("From one place to all",
             "girth field --field distance gives each vertex its distance from the nearest of some "
             "points.");
  return [options, writers] {
    return measure(
        *options, [&](const io::LoadedMesh& loaded) { return compute(*options, loaded); }, writers);
  };
}

}  // namespace
}  // namespace distance_command

const Command kDistance{"distance", "Measure between pairs of points, along the surface",
                        distance_command::add};

}  // namespace girth::cli
