// girth parts: tubes and plates, and what is too thin to print.
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/io/write_field.h"
#include "girth/io/write_parts.h"
#include "girth/parts.h"
#include "model/computing.h"
#include "model/loading.h"
#include "process/exit_codes.h"
#include "process/output.h"
#include "process/report.h"
#include "text/length_text.h"

namespace girth::cli {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  Output output;
  unsigned threads{0};
  bool json{false};
  /// Lengths as typed, with or without a unit. Empty: found from the fields (thresholds), or not
  /// checked (limits).
  std::string girth, diameter, minTube, minWall;
  double smoothing{0};
  bool positions{false};
};

std::string vertexText(const io::LoadedMesh& loaded, Index vertex) {
  if (vertex == kNoIndex || loaded.inputOfVertex[vertex] == kNoIndex) return "-";
  return std::to_string(loaded.inputOfVertex[vertex]);
}

std::string placeText(const io::LoadedMesh& loaded, Index vertex) {
  if (vertex == kNoIndex) return "-";
  const Vec3& p = loaded.mesh.position(Vertex(vertex));
  return readable(p.x) + " " + readable(p.y) + " " + readable(p.z);
}

void printParts(const std::string& model, const io::LoadedMesh& loaded, const Parts& parts,
                const PartOptions& options) {
  constexpr std::size_t kShown = 20;
  const std::string unit = unitSuffix(loaded.unit);
  std::printf("%s: %zu part%s; thin: thickness below %s%s; tubes: girth below %s%s\n",
              model.c_str(), parts.parts.size(), parts.parts.size() == 1 ? "" : "s",
              readable(options.thresholds.thickness).c_str(), unit.c_str(),
              readable(options.thresholds.girth).c_str(), unit.c_str());
  std::printf("  %4s %-8s %12s %12s %12s %12s  %s\n", "part", "kind", "area", "girth", "thickness",
              "radius", "thinnest at vertex");
  for (std::size_t i = 0; i < parts.parts.size() && i < kShown; ++i) {
    const Part& part = parts.parts[i];
    std::printf("  %4zu %-8s %12s %12s %12s %12s  %s\n", i,
                std::string(toString(part.kind)).c_str(), readable(part.area).c_str(),
                readableOrDash(part.medianGirth).c_str(),
                readableOrDash(part.medianThickness).c_str(),
                part.kind == PartKind::Tube ? readable(part.equivalentRadius()).c_str() : "-",
                vertexText(loaded, part.thinnest).c_str());
  }
  if (parts.parts.size() > kShown) {
    std::printf("  and %zu smaller ones\n", parts.parts.size() - kShown);
  }
  if (!parts.parts.empty()) printUnits(loaded.unit);
}

/// "12%", "<1%": a share of something.
std::string percent(double share) {
  const double hundredths = 100 * share;
  return hundredths < 1 ? "<1%" : readable(std::round(hundredths)) + "%";
}

/// "112%": a scale from which something holds, never rounded down.
std::string percentFrom(double scale) {
  return std::isfinite(scale) ? readable(std::ceil(100 * scale)) + "%" : "no scale";
}

void printPlaces(const std::string& model, const io::LoadedMesh& loaded,
                 const std::vector<WeakPlace>& places, double scale) {
  const std::string unit = unitSuffix(loaded.unit);
  if (places.empty()) {
    std::printf("%s: passes: nothing is too thin, down to %s of this size\n", model.c_str(),
                percentFrom(scale).c_str());
    return;
  }
  std::printf("%s: fails: %zu place%s too thin, %s of the surface; passes from %s of this size\n",
              model.c_str(), places.size(), places.size() == 1 ? "" : "s",
              percent(failingShare(loaded.mesh, places)).c_str(), percentFrom(scale).c_str());
  std::printf("  %-5s %-9s %12s %12s %10s  %s\n", "kind", "measure", "least", "area", "vertex",
              "at");
  for (const WeakPlace& place : places) {
    const bool isTube = place.kind == PartKind::Tube;
    std::printf("  %-5s %-9s %12s %12s %10s  %s%s\n", isTube ? "tube" : "wall",
                isTube ? "diameter" : "thickness", readable(place.least).c_str(),
                readable(place.area).c_str(), vertexText(loaded, place.thinnest).c_str(),
                placeText(loaded, place.thinnest).c_str(), unit.c_str());
  }
  printUnits(loaded.unit);
}

/// Reads a length where one was given.
std::optional<Error> readLength(const std::string& text, const std::string& unit, double& length) {
  if (text.empty()) return std::nullopt;
  const auto read = io::lengthInUnit(text, unit);
  if (!read) return read.error();
  length = read.value();
  return std::nullopt;
}

std::string contentFor(const Options& options, const io::LoadedMesh& loaded,
                       const std::string& json, const GirthField& girth,
                       const ShapeDiameterField& diameter, const Parts& parts) {
  static constexpr std::array kKinds{PartKind::Body, PartKind::Tube, PartKind::Plate,
                                     PartKind::Unknown};
  const std::string ending = options.output.ending();
  if (ending == ".json") return json;
  std::vector<std::string_view> words;
  for (const PartKind kind : kKinds) words.push_back(toString(kind));
  std::vector<double> numbers(parts.partOf.begin(), parts.partOf.end()), kinds;
  for (const PartKind kind : parts.kinds) kinds.push_back(static_cast<double>(kind));
  io::VertexField igf = io::girthVertexField(girth, GirthMethod::Exact, loaded.unit);
  igf.kindName = "loop_kind";
  const std::array<io::VertexField, 4> fields{
      igf, io::VertexField{"sdf", diameter.values, loaded.unit, "", {}},
      io::VertexField{"part", numbers, "", "", {}},
      io::VertexField{"part_kind", kinds, "", "", {}, "", words}};
  return ending == ".csv" ? io::fieldCsv(loaded, fields, columnsOf(options.positions))
                          : io::fieldPly(loaded, fields);
}

int run(const Options& options) {
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const io::LoadedMesh& model = loaded.value();

  // The typed lengths are checked before long work.
  PartOptions partOptions;
  partOptions.smoothing = options.smoothing;
  double tau1 = -1, tau2 = -1;
  PrintLimits limits;
  for (const auto& [text, length] : {std::pair{&options.girth, &tau1},
                                     {&options.diameter, &tau2},
                                     {&options.minTube, &limits.tubeDiameter},
                                     {&options.minWall, &limits.wallThickness}}) {
    if (auto error = readLength(*text, model.unit, *length)) return reportError("", *error);
  }
  const auto diameter = computeDiameter(options.model, model.mesh, {}, options.threads);
  if (!diameter) return reportError(options.model, diameter.error());
  // Before the girth, which takes longer.
  if (const auto error = whyNotChecked(model.mesh, diameter.value().values, limits)) {
    return reportError(options.model, *error);
  }
  const auto girth = computeGirth(options.model, model.mesh, options.threads);
  if (!girth) return reportError(options.model, girth.error());

  const std::vector<double>&i = girth.value().values, &sdf = diameter.value().values;
  partOptions.thresholds = suggestedThresholds(model.mesh, i, sdf);
  if (tau1 >= 0) partOptions.thresholds.girth = tau1;
  if (tau2 >= 0) partOptions.thresholds.thickness = tau2;
  const auto parts = findParts(model.mesh, i, sdf, partOptions);
  if (!parts) return reportError(options.model, parts.error());
  const auto places = findWeakPlaces(model.mesh, i, sdf, limits);
  if (!places) return reportError(options.model, places.error());

  const bool checks = !options.minTube.empty() || !options.minWall.empty();
  const double scale = passingScale(i, sdf, limits);
  const std::string json =
      checks ? io::weakPlacesJson(model, places.value(), limits, scale, options.model)
             : io::partsJson(model, parts.value(), partOptions, options.model);
  if (options.output.isWanted()) {
    if (auto error = writeOutput(options.output, contentFor(options, model, json, girth.value(),
                                                            diameter.value(), parts.value()))) {
      return reportError(options.output.path, *error);
    }
  }
  if (options.json) {
    std::fputs(json.c_str(), stdout);
  } else if (!hasSummary()) {
    // The exit code says it.
  } else if (checks) {
    printPlaces(options.model, model, places.value(), scale);
  } else {
    printParts(options.model, model, parts.value(), partOptions);
  }
  return checks && !places.value().empty() ? kCheckFails : 0;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  const auto length = [&table](const char* declaration, std::string& target, const char* text) {
    // An empty one is a slip, such as a variable of a script that is not set: not the same as none.
    table.onValue(
        declaration,
        [&target](const std::string& typed) {
          target = typed;
          return std::string(typed.empty() ? "the length is missing" : "");
        },
        text);
  };
  length("--girth LENGTH", options->girth, "Tubes have a girth below this length (tau 1)");
  length("--thickness LENGTH", options->diameter,
         "Tubes and plates are thinner than this length (tau 2)");
  table
      .add("--smooth WEIGHT", options->smoothing,
           "What all neighbours of a vertex count against its own kind; 0 by default")
      .range(0, 1e6);
  length("--min-tube LENGTH", options->minTube,
         "List tubes thinner than this diameter, as in 3mm; ends with 4 if there are any");
  length("--min-wall LENGTH", options->minWall,
         "List walls thinner than this, as in 1mm; ends with 4 if there are any");
  addOutputOptions(table, options->output, {".json", ".csv", ".ply"},
                   "Write the answer: .json, or every vertex with its part: .csv, .ply");
  addPositionsOption(table, options->positions);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth parts chair.glb -o parts.json",
                "Tubes, plates and body, by thresholds that the model's own values suggest.");
  table.example("girth parts part.stl --unit mm --min-tube 3mm --min-wall 1mm",
                "What is too thin to print; ends with 4 if anything is.");
  return [options] { return run(*options); };
}

}  // namespace

const Command kParts{"parts", "Find tubes and plates, or what is too thin to print", add};

}  // namespace girth::cli
