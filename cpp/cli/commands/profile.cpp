// girth profile: the girth along a path.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/geodesic_solver.h"
#include "girth/io/write_path_profile.h"
#include "girth/path_profile.h"
#include "model/loading.h"
#include "model/typed_point.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace {

struct Options {
  std::string model;
  std::vector<std::string> points;
  ModelOptions preparing;
  PathProfileOptions profile;
  bool even{false};
  Output output;
  unsigned threads{0};
  bool json{false};
};

/// The shortest paths from each point to the next, as one.
Result<std::vector<SurfacePoint>> pathOf(const Options& options, const io::LoadedMesh& loaded,
                                         const std::vector<TypedPoint>& typed) {
  GeodesicSolver solver(loaded.mesh);
  std::vector<SurfacePoint> path;
  SurfacePoint before;
  for (std::size_t i = 0; i < typed.size(); ++i) {
    const auto point = surfacePoint(loaded, typed[i], options.model, options.preparing);
    if (!point) return point.error();
    if (i > 0) {
      const auto found = solver.path(before, point.value());
      if (!found) return found.error();
      if (!std::isfinite(found.value().length)) {
        Error error = makeError(
            ErrorCode::InvalidPoint, -1,
            typed[i - 1].text() + " and " + typed[i].text() + " lie in different components");
        error.hint = "choose points that a way over the surface joins";
        return error;
      }
      path.insert(path.end(), found.value().points.begin(), found.value().points.end());
    }
    before = point.value();
  }
  return path;
}

void printText(const Options& options, const io::LoadedMesh& loaded,
               const std::vector<PathStation>& stations) {
  const auto [least, greatest] =
      std::minmax_element(stations.begin(), stations.end(),
                          [](const auto& a, const auto& b) { return a.girth < b.girth; });
  const std::string unit = unitSuffix(loaded.unit);
  std::printf("%s: %zu places on a path of length %s%s\n", options.model.c_str(), stations.size(),
              readable(stations.back().distance).c_str(), unit.c_str());
  std::printf("  %-9s %s%s at distance %s%s\n", "least", readable(least->girth).c_str(),
              unit.c_str(), readable(least->distance).c_str(), unit.c_str());
  std::printf("  %-9s %s%s at distance %s%s\n", "greatest", readable(greatest->girth).c_str(),
              unit.c_str(), readable(greatest->distance).c_str(), unit.c_str());
}

int run(const Options& options) {
  std::vector<TypedPoint> typed(options.points.size());
  for (std::size_t i = 0; i < typed.size(); ++i) {
    const std::string problem = readPoint(options.points[i], typed[i]);
    if (!problem.empty()) return reportError("", usageError(problem, "see girth profile --help"));
  }
  if (typed.size() < 2) {
    return reportError("", usageError("a path needs two points", "name two points or more"));
  }
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const auto path = pathOf(options, loaded.value(), typed);
  if (!path) return reportError(options.model, path.error());
  PathProfileOptions wanted = options.profile;
  wanted.crossings = !options.even;
  const auto stations = [&] {
    ProgressLine progress(options.model);
    return girthAlong(loaded.value().mesh, path.value(), wanted,
                      watched(options.threads, progress));
  }();
  if (!stations) return reportError(options.model, stations.error());
  if (options.output.isWanted()) {
    const Result<std::string> content =
        options.output.ending() == ".csv"
            ? io::pathProfileCsv(loaded.value(), stations.value())
            : io::pathProfileJson(loaded.value(), stations.value(), options.model);
    if (auto error = writeResult(options.output, content)) {
      return reportError(options.output.path, *error);
    }
  }
  if (options.json) {
    std::fputs(io::pathProfileJson(loaded.value(), stations.value(), options.model).c_str(),
               stdout);
  } else if (hasSummary()) {
    printText(options, loaded.value(), stations.value());
  }
  return 0;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  table
      .add("POINT", options->points,
           "Two points or more, joined by shortest paths: vertices, numbered as in the file from "
           "0, or points of faces, as in 7:0.2,0.3,0.5, the shares of the three vertices")
      .required();
  table.add("--samples N", options->profile.samples,
            "Places at equal distances, both ends among them; 100 by default, 0 for none");
  table.add("--even", options->even,
            "These only, and not where the path crosses edges and passes vertices");
  addOutputOptions(table, options->output, {".csv", ".json"},
                   "Write the profile: .csv (a row for each place) or .json");
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth profile vessel.stl 120 4803 -o profile.csv",
                "Along the shortest path: where it gets narrower, and how fast.");
  table.example("girth profile model.glb 12 431 97 --samples 500 --even -o profile.csv",
                "Along a path drawn by three points, at 500 equal distances.");
  return [options] { return run(*options); };
}

}  // namespace

const Command kProfile{"profile", "Measure the girth along a path", add};

}  // namespace girth::cli
