// girth cut: the surface taken apart along loops.
#include "girth/cut_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/girth_solver.h"
#include "girth/handles.h"
#include "girth/io/write_cut.h"
#include "girth/io/write_mesh.h"
#include "girth/level_curves.h"
#include "girth/necks.h"
#include "model/clear_necks.h"
#include "model/computing.h"
#include "model/curve_file.h"
#include "model/loading.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace cut_command {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  Output output;
  unsigned threads{0};
  /// In the file's numbering, from 0: along the loop there.
  std::optional<std::int64_t> vertex;
  /// From 1, as `girth necks` prints it.
  std::optional<std::int64_t> neck;
  bool allNecks{false};
  /// From 1, as `girth handles` prints it.
  std::optional<std::int64_t> handle;
  bool allHandles{false};
  /// As typed, with or without a unit: along the curves where the girth has this value.
  std::string level;
  /// A file with curves.
  std::string curves;
  /// As typed, with or without a unit. Empty: the suggested one.
  std::string minProminence;
  bool cap{false};
  bool json{false};
};

/// The necks that are cut along.
Result<std::vector<SurfaceCurve>> neckCurves(const Options& options, const io::LoadedMesh& loaded) {
  const auto typed = readProminence(options.minProminence, loaded.unit);
  if (!typed) return typed.error();
  // One neck may be named that is not clear.
  const auto least = options.neck ? std::optional(typed.value().value_or(0)) : typed.value();
  const auto girth = computeGirth(options.model, loaded.mesh, 0, options.threads, kRemeshFirst);
  if (!girth) return girth.error();
  const auto found =
      computeNecks(options.model, loaded, girth.value().values, least, options.threads);
  if (!found) return found.error();
  const std::vector<Neck>& necks = found.value().necks;
  std::vector<SurfaceCurve> curves;
  if (!options.neck) {
    for (const Neck& neck : necks) curves.push_back(neck.points);
    return curves;
  }
  const auto number = numberWithin(*options.neck, necks.size(), "necks",
                                   "the model has none; name a vertex, whose loop is cut along");
  if (!number) return number.error();
  curves.push_back(necks[number.value()].points);
  return curves;
}

/// The loops round handles that are cut along.
Result<std::vector<SurfaceCurve>> handleCurves(const Options& options,
                                               const io::LoadedMesh& loaded) {
  auto found = [&] {
    ProgressLine progress(options.model);
    return findHandles(loaded.mesh, {}, watched(options.threads, progress));
  }();
  if (!found) return found.error();
  const std::vector<Handle>& handles = found.value().handles;
  std::vector<SurfaceCurve> curves;
  if (!options.handle) {
    for (const Handle& handle : handles) {
      if (handle.kind == HandleKind::Handle) curves.push_back(handle.points);
    }
    return curves;
  }
  const auto number =
      numberWithin(*options.handle, handles.size(), "handles", "the model has none");
  if (!number) return number.error();
  curves.push_back(handles[number.value()].points);
  return curves;
}

/// The contour of the girth that is cut along.
Result<std::vector<SurfaceCurve>> levelCurvesOf(const Options& options,
                                                const io::LoadedMesh& loaded) {
  double level = 0;
  if (const auto error = readLength(options.level, loaded.unit, level)) return *error;
  const auto girth = computeGirth(options.model, loaded.mesh, 0, options.threads, kRemeshFirst);
  if (!girth) return girth.error();
  const std::vector<double>& values = girth.value().values;
  auto curves = levelCurves(loaded.mesh, values, level);
  if (curves && curves.value().empty()) {
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    return makeError(ErrorCode::ValueOutOfRange, -1,
                     "the girth is nowhere " + options.level + ": it goes from " +
                         readable(*least) + " to " + readable(*greatest) + unitSuffix(loaded.unit));
  }
  return curves;
}

Result<std::vector<SurfaceCurve>> loopCurve(std::int64_t number, const io::LoadedMesh& loaded) {
  const Result<Vertex> vertex = surfaceVertex(loaded, number);
  if (!vertex) return vertex.error();
  auto loop = GirthSolver(loaded.mesh).loop(vertex.value());
  if (!loop) return loop.error();
  if (loop.value().kind != LoopKind::Loop) {
    Error error = makeError(ErrorCode::InvalidOption, number,
                            "no loop goes round at vertex " + std::to_string(number));
    error.hint = "choose a vertex where girth loop has the kind loop";
    return error;
  }
  return std::vector<SurfaceCurve>{std::move(loop).value().points};
}

/// How many ways to name curves were used: one is right.
int namedOf(const Options& options) {
  return int{options.vertex.has_value()} + int{options.neck.has_value()} + int{options.allNecks} +
         int{options.handle.has_value()} + int{options.allHandles} + int{!options.level.empty()} +
         int{!options.curves.empty()};
}

Result<std::vector<SurfaceCurve>> curvesOf(const Options& options, const io::LoadedMesh& loaded) {
  if (options.vertex) return loopCurve(*options.vertex, loaded);
  if (options.handle || options.allHandles) return handleCurves(options, loaded);
  if (!options.level.empty()) return levelCurvesOf(options, loaded);
  if (!options.curves.empty()) return readCurveFile(options.curves, loaded);
  return neckCurves(options, loaded);
}

void printText(const Options& options, const io::LoadedMesh& loaded, std::size_t curves,
               const io::CutModel& model) {
  const std::size_t count = model.parts.size();
  std::printf("%s: cut along %zu loop%s: %zu part%s\n", options.model.c_str(), curves,
              curves == 1 ? "" : "s", count, count == 1 ? "" : "s");
  std::printf("  %4s %12s %12s %6s %10s\n", "part", "area", "faces", "genus", "boundaries");
  for (std::size_t i = 0; i < count; ++i) {
    const SurfaceMesh& mesh = model.parts[i].mesh;
    const PartMeasures measures = partMeasures(mesh);
    std::printf("  %4zu %12s %12u %6u %10u\n", i, readable(measures.area).c_str(), mesh.faceCount(),
                measures.genus, measures.boundaries);
  }
  printUnits(loaded.unit);
}

Result<std::string> contentFor(const std::string& ending, const io::LoadedMesh& loaded,
                               const io::CutModel& model, const std::string& file) {
  if (ending == ".glb") return io::cutGlb(loaded, model);
  if (ending == ".obj") return io::cutObj(loaded, model);
  if (ending == ".csv") return io::cutCsv(loaded, model);
  return io::cutJson(loaded, model, file);
}

bool hasFileForEachPart(const Output& output) { return output.path.find('*') != std::string::npos; }

/// The output of one part: its number in place of the star.
Output outputOf(const Output& output, std::size_t part) {
  Output one = output;
  one.path.replace(one.path.find('*'), 1, std::to_string(part));
  return one;
}

std::optional<Error> checkOutputs(const Options& options, std::size_t parts) {
  const std::string ending = options.output.ending();
  const bool isSurface = ending != ".csv" && ending != ".json";
  if (!hasFileForEachPart(options.output)) {
    if (ending == ".stl" || ending == ".ply" || ending == ".off") {
      return usageError("such a file has one part only",
                        "put a star into the name for a file each, as in 'part-*" + ending + "'");
    }
    return checkOutput(options.output, std::span(&options.model, 1), options.json);
  }
  if (!isSurface) {
    return usageError("a " + ending + " file is not written for each part",
                      "leave the star out, or write .stl, .obj, .ply, .off or .glb");
  }
  for (std::size_t i = 0; i < parts; ++i) {
    if (auto error =
            checkOutput(outputOf(options.output, i), std::span(&options.model, 1), options.json)) {
      return error;
    }
  }
  return std::nullopt;
}

/// The failed file's name is in the error.
std::optional<Error> writeParts(const Options& options, const io::LoadedMesh& loaded,
                                const io::CutModel& model) {
  if (!hasFileForEachPart(options.output)) {
    auto error = writeResult(options.output,
                             contentFor(options.output.ending(), loaded, model, options.model));
    if (error) error->file = options.output.path;
    return error;
  }
  // None is written before it is known that all can be.
  if (auto error = checkOutputs(options, model.parts.size())) return error;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Output output = outputOf(options.output, i);
    if (auto error =
            writeResult(output, io::partFile(loaded, model, i, *io::meshFormat(output.ending())))) {
      error->file = output.path;
      return error;
    }
  }
  return std::nullopt;
}

int run(const Options& options) {
  if (namedOf(options) != 1) {
    return reportError("",
                       usageError(namedOf(options) == 0 ? "no loop is named"
                                                        : "several things to cut along are named",
                                  "name a vertex, a neck with --neck, or all with --necks; or "
                                  "use --handle, --handles, --at or --along"));
  }
  if (!options.minProminence.empty() && !options.neck && !options.allNecks) {
    return reportError("", usageError("--min-prominence has an effect on --neck and --necks only",
                                      "leave it out"));
  }
  if (const auto error = checkOutputs(options, 1)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing, {true});
  if (!loaded) return reportError(options.model, loaded.error());
  for (const std::string& note : loaded.value().attributeNotes) printNote(options.model, note);
  const auto curves = curvesOf(options, loaded.value());
  if (!curves) {
    const std::string& file = curves.error().file;
    return reportError(file.empty() ? options.model : file, curves.error());
  }
  const auto cut = [&] {
    ProgressLine progress(options.model);
    return cutSurface(loaded.value().mesh, curves.value(), {options.cap}, watched(1, progress));
  }();
  if (!cut) return reportError(options.model, cut.error());
  const io::CutModel model = io::cutModel(cut.value());
  if (options.output.isWanted()) {
    if (auto error = writeParts(options, loaded.value(), model)) {
      return reportError(error->file.empty() ? options.output.path : error->file, *error);
    }
  }
  if (options.json) {
    std::fputs(io::cutJson(loaded.value(), model, options.model).c_str(), stdout);
  } else if (hasSummary()) {
    printText(options, loaded.value(), curves.value().size(), model);
  }
  return 0;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  table.add("VERTEX", options->vertex,
            "Cut along the loop at this vertex, numbered as in the file from 0");
  table.add("--neck N", options->neck, "Cut along one neck, numbered as girth necks lists it");
  table.add("--necks", options->allNecks, "Cut along all necks");
  addProminenceOption(table, options->minProminence, "Only necks of at least this prominence");
  table.add("--handle N", options->handle,
            "Cut along the loop of one handle or tunnel, numbered as girth handles lists it");
  table.add("--handles", options->allHandles,
            "Cut along the loops round all handles: the material is cut, and tunnels are opened");
  addLengthOption(
      table, "--at LENGTH", options->level,
      "Cut along the contour where the girth has this value, as in 30mm, linear between "
      "vertices");
  table.add(
      "--along FILE", options->curves,
      "Cut along the loops of a .json or .obj file, as girth loop, necks, handles, bottleneck "
      "and tighten write them");
  table.add("--cap", options->cap,
            "Close the rims that cutting makes; hollow bodies are cut with their cavities");
  addOutputOptions(table, options->output,
                   {".glb", ".obj", ".json", ".csv", ".stl", ".ply", ".off"},
                   "Write the parts: .glb (a node for each), .obj (an object for each), .json "
                   "(what they measure), .csv (the part of each face); or a file for each, where "
                   "the name has a star for its number: 'part-*.stl', also .obj, .ply, .off, .glb");
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth cut figure.stl --neck 0 --cap -o parts.glb",
                "Two parts, cut at the clearest neck and closed.");
  table.example("girth cut model.glb --necks --min-prominence 5mm -o segments.csv",
                "The parts of a body, as a label for each face.");
  table.example("girth cut ring.stl --handle 0 --cap -o 'part-*.stl'",
                "Cut along the loop of a handle; each part has its own file.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace cut_command

const Command kCut{"cut", "Cut a surface along loops and necks", cut_command::add};

}  // namespace girth::cli
