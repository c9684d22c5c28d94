// girth profile: the girth along a path, or along the axis of a limb.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/io/write_limb_axis.h"
#include "girth/io/write_path_profile.h"
#include "girth/limb_axis.h"
#include "girth/limbs.h"
#include "girth/path_profile.h"
#include "model/computing.h"
#include "model/loading.h"
#include "model/typed_point.h"
#include "process/hand_over.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace profile_command {
namespace {

struct Options {
  std::string model;
  std::vector<std::string> points;
  /// From 1, as `girth limbs` prints it: along its axis.
  std::optional<std::int64_t> limb;
  ModelOptions preparing;
  PathProfileOptions profile;
  bool even{false};
  Output output;
  unsigned threads{0};
  bool json{false};
};

void printText(const Options& options, const io::LoadedMesh& loaded,
               const std::vector<PathStation>& stations, const PathStation& least) {
  const auto greatest =
      std::max_element(stations.begin(), stations.end(),
                       [](const auto& a, const auto& b) { return a.girth < b.girth; });
  const std::string unit = unitSuffix(loaded.unit);
  std::printf("%s: %zu places on a path of length %s%s\n", options.model.c_str(), stations.size(),
              readable(stations.back().distance).c_str(), unit.c_str());
  const auto row = [&](const char* name, const PathStation& station) {
    const std::string kind = station.kind == LoopKind::Loop
                                 ? ""
                                 : ", " + std::string(toString(station.kind)) + ": no loop there";
    std::printf("  %-9s %s%s at distance %s%s%s\n", name, readable(station.girth).c_str(),
                unit.c_str(), readable(station.distance).c_str(), unit.c_str(), kind.c_str());
  };
  row("least", least);
  row("greatest", *greatest);
  if (options.even) {
    std::printf("  between these places it may be less; without --even crossed edges count too\n");
  }
}

/// The axis of the limb that is named, with a loop for each sample.
Result<std::vector<AxisStation>> axisOf(const Options& options, const SurfaceMesh& mesh) {
  const auto tips = computeTips(options.model, mesh, 0, options.threads);
  if (!tips) return tips.error();
  ProgressLine progress(options.model);
  const auto found =
      findLimbs(mesh, tips.value().girth.values, tips.value().tips.tips,
                {static_cast<Index>(options.profile.samples)}, watched(options.threads, progress));
  if (!found) return found.error();
  const std::vector<Limb>& limbs = found.value().limbs;
  const auto number = numberWithin(*options.limb, limbs.size(), "limbs",
                                   "the model has none; name points of a path");
  if (!number) return number.error();
  return limbAxis(mesh, limbs[number.value()].profile, watched(options.threads, progress));
}

void printAxis(const Options& options, const io::LoadedMesh& loaded,
               const std::vector<AxisStation>& axis) {
  const auto [least, greatest] = std::minmax_element(
      axis.begin(), axis.end(), [](const auto& a, const auto& b) { return a.girth < b.girth; });
  const std::string unit = unitSuffix(loaded.unit);
  std::printf("%s: %zu loops along an axis of length %s%s\n", options.model.c_str(), axis.size(),
              readable(axis.empty() ? 0 : axis.back().distance).c_str(), unit.c_str());
  if (axis.empty()) return;
  std::printf("  %-9s %s%s at distance %s%s\n", "least", readable(least->girth).c_str(),
              unit.c_str(), readable(least->distance).c_str(), unit.c_str());
  std::printf("  %-9s %s%s at distance %s%s\n", "greatest", readable(greatest->girth).c_str(),
              unit.c_str(), readable(greatest->distance).c_str(), unit.c_str());
}

Result<std::string> axisContent(const std::string& ending, const io::LoadedMesh& loaded,
                                const std::vector<AxisStation>& axis, const std::string& file) {
  if (ending == ".csv") return io::limbAxisCsv(loaded, axis);
  if (ending == ".obj") return io::limbAxisObj(loaded, axis);
  if (ending == ".glb") return io::limbAxisGlb(loaded, axis);
  return io::limbAxisJson(loaded, axis, file);
}

int runAlongLimb(const Options& options) {
  constexpr std::size_t kMostStations = 10'000;
  if (!options.points.empty() || options.even) {
    return reportError("", usageError("a limb has an axis of its own",
                                      "leave out the points and --even, or leave out --limb"));
  }
  if (options.profile.samples < 1 || options.profile.samples > kMostStations) {
    return reportError("", usageError("along a limb there are 1 to 10,000 samples",
                                      "choose another number for --samples"));
  }
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const auto axis = axisOf(options, loaded.value().mesh);
  if (!axis) return reportError(options.model, axis.error());
  return handOver(
      options.output, options.json,
      [&](const std::string& ending) {
        return axisContent(ending, loaded.value(), axis.value(), options.model);
      },
      [&] { return io::limbAxisJson(loaded.value(), axis.value(), options.model); },
      [&] { printAxis(options, loaded.value(), axis.value()); });
}

int run(const Options& options) {
  if (options.limb) return runAlongLimb(options);
  const std::string ending = options.output.ending();
  if (ending == ".obj" || ending == ".glb") {
    return reportError(options.output.path,
                       usageError("the loops are written along a limb only",
                                  "name one with --limb, or write .csv or .json"));
  }
  std::vector<TypedPoint> typed(options.points.size());
  for (std::size_t i = 0; i < typed.size(); ++i) {
    const std::string problem = readPoint(options.points[i], typed[i]);
    if (!problem.empty()) return reportError("", usageError(problem, "see girth profile --help"));
  }
  if (typed.size() < 2) {
    return reportError("", usageError("a path needs two points",
                                      "name two points or more, or a limb with --limb"));
  }
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const auto points = surfacePoints(loaded.value(), typed, options.model, options.preparing);
  if (!points) return reportError(options.model, points.error());
  const auto path = shortestPathThrough(loaded.value().mesh, points.value());
  if (!path) return reportError(options.model, path.error());
  PathProfileOptions wanted = options.profile;
  wanted.crossings = !options.even;
  const auto stations = [&] {
    ProgressLine progress(options.model);
    return girthAlong(loaded.value().mesh, path.value(), wanted,
                      watched(options.threads, progress));
  }();
  if (!stations) return reportError(options.model, stations.error());
  const auto least = leastAlong(loaded.value().mesh, path.value(), stations.value());
  if (!least) return reportError(options.model, least.error());
  return handOver(
      options.output, options.json,
      [&](const std::string& written) -> Result<std::string> {
        if (written == ".csv") return io::pathProfileCsv(loaded.value(), stations.value());
        return io::pathProfileJson(loaded.value(), stations.value(), options.model);
      },
      [&] { return io::pathProfileJson(loaded.value(), stations.value(), options.model); },
      [&] { printText(options, loaded.value(), stations.value(), least.value()); });
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  table.add("POINT", options->points,
            "Two points or more, joined by shortest paths: vertices, numbered as in the file from "
            "0, or points of faces, as in 7:0.2,0.3,0.5, the shares of the three vertices");
  table.add("--limb N", options->limb,
            "Along the axis of a limb instead, numbered as girth limbs lists it: the middles "
            "of the loops round it");
  table.add("--samples N", options->profile.samples,
            "Places at equal distances, both ends among them; 100 by default, 0 for none. Along a "
            "limb, so many loops at most");
  table.add("--even", options->even,
            "Only these places, none where the path crosses edges or passes vertices");
  addOutputOptions(table, options->output, {".csv", ".json", ".obj", ".glb"},
                   "Write the profile: .csv (a row for each place) or .json; along a limb also "
                   ".obj and .glb, its loops as lines");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth profile vessel.stl 120 4803 -o profile.csv",
                "Along the shortest path: where it gets narrower, and how fast.");
  table.example("girth profile model.glb 12 431 97 --samples 500 --even -o profile.csv",
                "Along a path drawn by three points, at 500 equal distances.");
  table.example("girth profile hand.glb --limb 0 -o finger.csv",
                "Along the axis of the longest limb.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace profile_command

const Command kProfile{"profile", "Measure the girth along a path, or along a limb",
                       profile_command::add};

}  // namespace girth::cli
