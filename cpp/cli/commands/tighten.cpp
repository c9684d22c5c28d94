// girth tighten: curves drawn tight.
#include "girth/tighten.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/common_options.h"
#include "commands/measure.h"
#include "commands/table.h"
#include "girth/describe/tighten.h"
#include "girth/io/result_csv.h"
#include "girth/io/result_json.h"
#include "girth/io/write_tighten.h"
#include "model/curve_file.h"
#include "model/typed_point.h"
#include "process/progress_line.h"
#include "process/report.h"
#include "text/ending.h"

namespace girth::cli {
namespace tighten_command {
namespace {

/// Pieces that are printed.
constexpr std::size_t kMostRows = 50;

struct Options : MeasuringOptions {
  /// As typed: a file or points.
  std::string along;
  /// From 0, in the file.
  std::optional<std::int64_t> curve;
  bool closed{false};
  bool fixed{false};
};

Result<std::vector<SurfacePoint>> typedPoints(const Options& options,
                                              const io::LoadedMesh& loaded) {
  std::vector<TypedPoint> typed;
  if (const std::string problem = readPoints(options.along, typed); !problem.empty()) {
    return usageError("--along: " + problem,
                      "name points, as in 12,88,7, or a .json, .obj or .csv file");
  }
  return surfacePoints(loaded, typed, options.model, options.preparing);
}

Result<std::vector<SurfacePoint>> pointsAlong(const Options& options,
                                              const io::LoadedMesh& loaded) {
  const std::string ending = io::endingOf(options.along);
  if (ending != ".json" && ending != ".obj") {
    if (options.curve) {
      return usageError("--curve needs a file of curves",
                        "leave it out, or name a .json or .obj file with --along");
    }
    return typedPoints(options, loaded);
  }
  auto curves = readCurveFile(options.along, loaded);
  if (!curves) return curves.error();
  const std::size_t count = curves.value().size();
  if (!options.curve && count != 1) {
    return usageError(options.along + " has " + std::to_string(count) + " curves",
                      count == 0 ? "name a file with one" : "name one, as in --curve 0");
  }
  const auto number =
      numberWithin(options.curve.value_or(0), count, "curves", "name a file with one");
  if (!number) return number.error();
  return std::move(curves.value()[number.value()]);
}

Result<TightCurve> compute(const Options& options, const io::LoadedMesh& loaded) {
  auto points = pointsAlong(options, loaded);
  if (!points) return points.error();
  ProgressLine progress(options.model);
  return tighten(loaded.mesh, {std::move(points).value(), options.closed, options.fixed},
                 watched(options.threads, progress));
}

const char* kindWords(TightKind kind) {
  switch (kind) {
    case TightKind::Path:
      return "path: its ends stay";
    case TightKind::Loop:
      return "loop: closed";
    case TightKind::Point:
      break;
  }
  return "point: it contracts, nothing on the surface holds it";
}

const char* promiseWords(TightPromise promise) {
  switch (promise) {
    case TightPromise::Shortest:
      return "shortest of its homotopy class";
    case TightPromise::Local:
      return "locally shortest: it may be shorter beyond a convex vertex";
    case TightPromise::Shorter:
      break;
  }
  return "no longer than before; given up after too many steps";
}

void printText(const Options& options, const io::LoadedMesh& loaded, const TightCurve& curve) {
  const std::string unit = unitSuffix(loaded.unit);
  const auto row = [](const char* name, const std::string& value) {
    std::printf("  %-8s %s\n", name, value.c_str());
  };
  std::printf("%s: the curve drawn tight\n", options.model.c_str());
  row("kind", kindWords(curve.kind));
  row("before", readable(curve.lengthBefore) + unit);
  row("length", readable(curve.length) + unit);
  row("promise", promiseWords(curve.promise));
  const std::size_t pieces = curve.pieces.size();
  for (std::size_t i = 0; pieces > 1 && i < pieces && i < kMostRows; ++i) {
    row(("piece " + std::to_string(i)).c_str(), readable(curve.pieces[i].length) + unit);
  }
  if (pieces > kMostRows) std::printf("  ... and %zu more, which -o writes\n", pieces - kMostRows);
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  const Writers<TightCurve> writers{
      {{".csv", io::resultCsv<TightCurve>}, {".obj", io::tightObj}, {".glb", io::tightGlb}},
      [options](const io::LoadedMesh& loaded, const TightCurve& curve) {
        return io::resultJson(loaded, curve, options->model);
      },
      [options](const io::LoadedMesh& loaded, const TightCurve& curve) {
        printText(*options, loaded, curve);
      }};
  table.add("MODEL", options->model, "The model to read").required();
  table
      .add(
          "--along CURVE", options->along,
          "The curve: points, as in 12,88,7 or 7:0.2,0.3,0.5; a .csv file of points; a .json file "
          "as girth loop, necks, handles, distance and tighten write it; or lines of an .obj file, "
          "taken to the surface")
      .required();
  table.add("--curve N", options->curve, "Which curve of the file, from 0, where it has several");
  table.add("--closed", options->closed,
            "The curve goes on from its last point to its first, and none stays");
  table.add("--fixed", options->fixed,
            "All points stay: the shortest pieces between each two neighbours");
  addOutputOptions(table, options->output, writers.endings(),
                   "Write the tight curve: .json, .obj or .glb (a line), or .csv (a row for each "
                   "piece)");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth tighten model.glb --along 12,88,7,40 --closed -o loop.obj",
                "The closed geodesic that a curve through four vertices is drawn tight to.");
  table.example("girth tighten model.glb --along drawn.obj -o path.json",
                "A drawn line between its ends, as long as its own way needs.");
  table.note(
      "Class",
      "The curve slides over the surface and never jumps a handle or hole: it is no shortcut "
      "on the other side.");
  return [options, writers] {
    return measure(
        *options, [&](const io::LoadedMesh& loaded) { return compute(*options, loaded); }, writers);
  };
}

}  // namespace
}  // namespace tighten_command

const Command kTighten{"tighten", "Draw a curve tight within its class", tighten_command::add};

}  // namespace girth::cli
