// girth parts: tubes and plates, and what is too thin to print.
#include <CLI/CLI.hpp>
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
#include "model/length_text.h"
#include "model/loading.h"
#include "process/files.h"
#include "process/report.h"

namespace girth::cli {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  std::string output;
  unsigned threads{0};
  bool json{false};
  /// Lengths as typed, with or without a unit. Empty: found from the fields (thresholds), or not
  /// checked (limits).
  std::string girth, diameter, minTube, minWall;
  double smoothing{0};
};

/// The exit code where something is too thin to print, for build scripts.
constexpr int kTooThin = 4;

std::string vertexText(const io::LoadedMesh& loaded, Index vertex) {
  if (vertex == kNoIndex || loaded.inputOfVertex[vertex] == kNoIndex) return "-";
  return std::to_string(loaded.inputOfVertex[vertex]);
}

std::string placeText(const io::LoadedMesh& loaded, Index vertex) {
  if (vertex == kNoIndex) return "-";
  const Vec3& p = loaded.mesh.position(Vertex(vertex));
  return readable(p.x) + " " + readable(p.y) + " " + readable(p.z);
}

std::string orDash(double value) { return std::isnan(value) ? "-" : readable(value); }

void printParts(const std::string& model, const io::LoadedMesh& loaded, const Parts& parts,
                const PartOptions& options) {
  constexpr std::size_t kShown = 20;
  const std::string unit = unitSuffix(loaded.unit);
  std::printf("%s: %zu part%s; thin: thickness below %s%s; tubes: girth below %s%s\n",
              model.c_str(), parts.parts.size(), parts.parts.size() == 1 ? "" : "s",
              readable(options.thresholds.diameter).c_str(), unit.c_str(),
              readable(options.thresholds.girth).c_str(), unit.c_str());
  std::printf("  %-8s %12s %12s %12s %12s  %s\n", "kind", "area", "girth", "thickness", "radius",
              "thinnest at vertex");
  for (std::size_t i = 0; i < parts.parts.size() && i < kShown; ++i) {
    const Part& part = parts.parts[i];
    std::printf("  %-8s %12s %12s %12s %12s  %s\n", std::string(toString(part.kind)).c_str(),
                readable(part.area).c_str(), orDash(part.medianGirth).c_str(),
                orDash(part.medianDiameter).c_str(),
                part.kind == PartKind::Tube ? readable(part.equivalentRadius()).c_str() : "-",
                vertexText(loaded, part.thinnest).c_str());
  }
  if (parts.parts.size() > kShown) {
    std::printf("  and %zu smaller ones\n", parts.parts.size() - kShown);
  }
  if (!parts.parts.empty()) printUnits(loaded.unit);
}

void printPlaces(const std::string& model, const io::LoadedMesh& loaded,
                 const std::vector<WeakPlace>& places) {
  const std::string unit = unitSuffix(loaded.unit);
  if (places.empty()) {
    std::printf("%s: passes: nothing is too thin\n", model.c_str());
    return;
  }
  std::printf("%s: fails: %zu place%s too thin\n", model.c_str(), places.size(),
              places.size() == 1 ? "" : "s");
  std::printf("  %-5s %12s %12s %10s  %s\n", "kind", "thickness", "area", "vertex", "at");
  for (const WeakPlace& place : places) {
    std::printf("  %-5s %12s %12s %10s  %s%s\n", place.kind == PartKind::Tube ? "tube" : "wall",
                readable(place.least).c_str(), readable(place.area).c_str(),
                vertexText(loaded, place.thinnest).c_str(),
                placeText(loaded, place.thinnest).c_str(), unit.c_str());
  }
  printUnits(loaded.unit);
}

/// Reads a length where one was given.
std::optional<Error> readLength(const std::string& text, const std::string& unit, double& length) {
  if (text.empty()) return std::nullopt;
  const auto read = lengthInModelUnit(text, unit);
  if (!read) return read.error();
  length = read.value();
  return std::nullopt;
}

std::string contentFor(const std::string& extension, const io::LoadedMesh& loaded,
                       const std::string& json, const GirthField& girth,
                       const ShapeDiameterField& diameter, const std::vector<PartKind>& kinds) {
  if (extension == ".json") return json;
  std::vector<double> numbers;
  for (const PartKind kind : kinds) numbers.push_back(static_cast<double>(kind));
  const std::array<io::VertexField, 3> fields{
      io::girthVertexField(girth, GirthMethod::Exact, loaded.unit),
      io::VertexField{"sdf", diameter.values, loaded.unit, "", {}},
      io::VertexField{"part", numbers, "", "", {}}};
  return extension == ".csv" ? io::fieldCsv(loaded, fields) : io::fieldPly(loaded, fields);
}

int run(const Options& options) {
  const std::string extension = extensionOf(options.output);
  if (!options.output.empty()) {
    if (auto error = checkOutput(options.output, {".json", ".csv", ".ply"})) {
      return reportError(options.output, *error);
    }
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
  if (tau2 >= 0) partOptions.thresholds.diameter = tau2;
  const auto parts = findParts(model.mesh, i, sdf, partOptions);
  if (!parts) return reportError(options.model, parts.error());
  const auto places = findWeakPlaces(model.mesh, i, sdf, limits);
  if (!places) return reportError(options.model, places.error());

  const bool checks = !options.minTube.empty() || !options.minWall.empty();
  const std::string json = checks ? io::weakPlacesJson(model, places.value(), limits, options.model)
                                  : io::partsJson(model, parts.value(), partOptions, options.model);
  if (!options.output.empty()) {
    if (auto error = writeFile(options.output, contentFor(extension, model, json, girth.value(),
                                                          diameter.value(), parts.value().kinds))) {
      return reportError(options.output, *error);
    }
  }
  if (options.json) {
    std::fputs(json.c_str(), stdout);
  } else if (checks) {
    printPlaces(options.model, model, places.value());
  } else {
    printParts(options.model, model, parts.value(), partOptions);
  }
  return checks && !places.value().empty() ? kTooThin : 0;
}

/// Checks that a length was typed. An empty one is a slip, such as a variable of a script that is
/// not set: not the same as none.
std::string isGiven(const std::string& length) {
  return length.empty() ? "the length is missing" : "";
}

Run add(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("MODEL", options->model, "The model to read")->required();
  addModelOptions(app, options->preparing);
  app.add_option("--girth", options->girth, "Tubes have a girth below this length (tau 1)")
      ->check(isGiven);
  app.add_option("--thickness", options->diameter,
                 "Tubes and plates are thinner than this length (tau 2)")
      ->check(isGiven);
  app.add_option("--smooth", options->smoothing,
                 "What all neighbours of a vertex count against its own kind; 0 by default")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--min-tube", options->minTube,
                 "List tubes thinner than this diameter, as in 3mm; ends with 4")
      ->check(isGiven);
  app.add_option("--min-wall", options->minWall,
                 "List walls thinner than this, as in 1mm; ends with 4")
      ->check(isGiven);
  app.add_option("-o,--output", options->output,
                 "Write the answer: .json, or every vertex with its part: .csv, .ply");
  addThreadsOption(app, options->threads);
  app.add_flag("--json", options->json, "Print everything as JSON");
  return [options] { return run(*options); };
}

}  // namespace

const Command kParts{"parts", "Find tubes and plates, or what is too thin to print", add};

}  // namespace girth::cli
