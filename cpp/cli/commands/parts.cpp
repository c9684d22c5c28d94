// girth parts: tubes and plates, and what is too thin to print.
#include <algorithm>
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
#include "girth/print_check.h"
#include "model/computing.h"
#include "model/loading.h"
#include "model/persistence.h"
#include "process/exit_codes.h"
#include "process/output.h"
#include "process/report.h"

namespace girth::cli {
namespace parts_command {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  Output output;
  unsigned threads{0};
  bool json{false};
  /// Lengths as typed, with or without a unit. Empty: found from the fields (thresholds), or not
  /// checked (limits).
  std::string girth, diameter, minTube, minWall, minGap;
  /// The girth's persistence, as typed: a length or a share.
  std::string persistence;
  double smoothing{0};
  bool positions{false};
  /// Whether creases fail, too.
  bool creases{false};
};

/// Places and creases that are listed, at most.
constexpr std::size_t kShownCreases = 20;

std::string vertexText(const io::LoadedMesh& loaded, Index vertex) {
  if (vertex == kNoIndex || loaded.inputOfVertex[vertex] == kNoIndex) return "-";
  return std::to_string(loaded.inputOfVertex[vertex]);
}

std::string placeText(const io::LoadedMesh& loaded, const SurfacePoint& point) {
  const Vec3 p = positionOf(loaded.mesh, point);
  return readable(p.x) + " " + readable(p.y) + " " + readable(p.z);
}

void printParts(const std::string& model, const io::LoadedMesh& loaded, const Parts& parts,
                const PartOptions& options, double persistence) {
  constexpr std::size_t kShown = 20;
  const std::string unit = unitSuffix(loaded.unit);
  std::printf("%s: %zu part%s; thin: shape diameter below %s%s; tubes: girth below %s%s%s\n",
              model.c_str(), parts.parts.size(), parts.parts.size() == 1 ? "" : "s",
              readable(options.thresholds.shapeDiameter).c_str(), unit.c_str(),
              readable(options.thresholds.girth).c_str(), unit.c_str(),
              persistenceText(persistence, loaded).c_str());
  std::printf("  %4s %-8s %12s %12s %12s %12s  %s\n", "part", "kind", "area", "girth", "diameter",
              "radius", "thinnest at vertex");
  for (std::size_t i = 0; i < parts.parts.size() && i < kShown; ++i) {
    const Part& part = parts.parts[i];
    std::printf("  %4zu %-8s %12s %12s %12s %12s  %s\n", i,
                std::string(toString(part.kind)).c_str(), readable(part.area).c_str(),
                readableOrDash(part.medianGirth).c_str(),
                readableOrDash(part.medianShapeDiameter).c_str(),
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

/// "walls and gaps": what limits are given for, or for what they are not.
std::string limitedWords(const PrintLimits& limits, bool given) {
  std::vector<std::string> words;
  if ((limits.tubeDiameter > 0) == given) words.emplace_back("tubes");
  if ((limits.wallThickness > 0) == given) words.emplace_back("walls");
  if ((limits.gap > 0) == given) words.emplace_back("gaps");
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
  }
  return text;
}

/// "passes from 112% of this size"; where no scale helps, how many places have nothing between
/// their faces.
std::string remedyWords(const PrintCheck& check) {
  const std::string remedy = "passes from " + percentFrom(check.passingScale) + " of this size";
  if (std::isfinite(check.passingScale)) return remedy;
  const auto count = std::count_if(check.places.begin(), check.places.end(),
                                   [](const WeakPlace& place) { return place.least == 0; });
  return remedy + ": at " + std::to_string(count) + (count == 1 ? " place" : " places") +
         " faces meet in a sharp edge or lie on each other";
}

/// "; 4 creases": what fails by no wall and no gap; empty where there is nothing.
std::string creaseWords(const std::vector<Crease>& creases) {
  if (creases.empty()) return "";
  return "; " + std::to_string(creases.size()) + (creases.size() == 1 ? " crease" : " creases");
}

void printCreases(const io::LoadedMesh& loaded, const std::vector<Crease>& creases) {
  if (creases.empty()) return;
  const std::string unit = unitSuffix(loaded.unit);
  std::printf("  %-8s %12s %12s %10s  %s\n", "crease", "length", "area", "vertex", "at");
  for (std::size_t i = 0; i < creases.size() && i < kShownCreases; ++i) {
    const Crease& crease = creases[i];
    std::printf("  %-8s %12s %12s %10s  %s%s\n", std::string(toString(crease.kind)).c_str(),
                readable(crease.length).c_str(), readable(crease.area).c_str(),
                vertexText(loaded, crease.thinnest.vertex()).c_str(),
                placeText(loaded, crease.thinnest).c_str(), unit.c_str());
  }
  if (creases.size() > kShownCreases) {
    std::printf("  and %zu shorter ones\n", creases.size() - kShownCreases);
  }
}

void printCheck(const std::string& model, const io::LoadedMesh& loaded, const PrintCheck& check,
                const PrintLimits& limits, double persistence) {
  static constexpr std::array kMeasures{"diameter", "thickness", "clearance"};
  const std::string unit = unitSuffix(loaded.unit);
  const std::vector<WeakPlace>& places = check.places;
  const std::string unchecked = limitedWords(limits, false);
  const std::string rest = (unchecked.empty() ? "" : "; not checked: " + unchecked) +
                           persistenceText(persistence, loaded);
  const std::string fault = limits.gap > 0 ? "too thin or too close" : "too thin";
  if (places.empty()) {
    std::printf("%s: passes: nothing is %s, down to %s of this size%s%s\n", model.c_str(),
                fault.c_str(), percentFrom(check.passingScale).c_str(),
                creaseWords(check.creases).c_str(), rest.c_str());
    printCreases(loaded, check.creases);
    if (!check.creases.empty()) printUnits(loaded.unit);
    return;
  }
  std::printf("%s: fails: %zu place%s %s, %s of the surface; %s%s%s\n", model.c_str(),
              places.size(), places.size() == 1 ? "" : "s", fault.c_str(),
              percent(check.failingShare).c_str(), remedyWords(check).c_str(),
              creaseWords(check.creases).c_str(), rest.c_str());
  std::printf("  %-5s %-9s %12s %12s %10s  %s\n", "kind", "measure", "least", "area", "vertex",
              "at");
  for (const WeakPlace& place : places) {
    std::printf("  %-5s %-9s %12s %12s %10s  %s%s\n", std::string(toString(place.kind)).c_str(),
                kMeasures[static_cast<std::size_t>(place.kind)], readable(place.least).c_str(),
                readable(place.area).c_str(), vertexText(loaded, place.thinnest.vertex()).c_str(),
                placeText(loaded, place.thinnest).c_str(), unit.c_str());
  }
  printCreases(loaded, check.creases);
  printUnits(loaded.unit);
}

std::string verticesFor(const Options& options, const io::LoadedMesh& loaded,
                        const GirthField& girth, const FieldValues& diameter, const Parts& parts,
                        double persistence) {
  static constexpr std::array kKinds{PartKind::Body, PartKind::Tube, PartKind::Plate,
                                     PartKind::Unknown};
  std::vector<std::string_view> words;
  for (const PartKind kind : kKinds) words.push_back(toString(kind));
  std::vector<double> numbers(parts.partOf.begin(), parts.partOf.end()), kinds;
  for (const PartKind kind : parts.kinds) kinds.push_back(static_cast<double>(kind));
  io::VertexField igf = io::girthVertexField(girth, GirthMethod::Exact, loaded.unit);
  igf.method = io::methodText(GirthOptions{GirthMethod::Exact, persistence});
  igf.kindName = "loopKind";
  const std::array<io::VertexField, 4> fields{
      igf, io::VertexField{"sdf", diameter.values, loaded.unit, "", {}},
      io::VertexField{"part", numbers, "", "", {}},
      io::VertexField{"partKind", kinds, "", "", {}, "", words}};
  return options.output.ending() == ".csv"
             ? io::fieldCsv(loaded, fields, columnsOf(options.positions))
             : io::fieldPly(loaded, fields);
}

/// The wanted parts and checks, with lengths as numbers.
struct Wanted {
  PartOptions parts;
  /// τ1 and τ2 where they are given.
  std::optional<double> girth, shapeDiameter;
  PrintLimits limits;
  /// The girth's persistence.
  double persistence{0};
  /// Whether limits are to be checked.
  bool checks{false};
};

Result<Wanted> wantedOf(const Options& options, const io::LoadedMesh& model) {
  Wanted wanted;
  wanted.parts.smoothing = options.smoothing;
  wanted.checks = !options.minTube.empty() || !options.minWall.empty() || !options.minGap.empty();
  double girth = 0, shapeDiameter = 0;
  for (const auto& [text, length] : {std::pair{&options.girth, &girth},
                                     {&options.diameter, &shapeDiameter},
                                     {&options.minTube, &wanted.limits.tubeDiameter},
                                     {&options.minWall, &wanted.limits.wallThickness},
                                     {&options.minGap, &wanted.limits.gap}}) {
    if (auto error = readLength(*text, model.unit, *length)) return *std::move(error);
  }
  const auto persistence = persistenceOf(options.persistence, model);
  if (!persistence) return persistence.error();
  wanted.persistence = persistence.value();
  if (!options.girth.empty()) wanted.girth = girth;
  if (!options.diameter.empty()) wanted.shapeDiameter = shapeDiameter;
  return wanted;
}

/// The fields of a model, each computed when it is first needed.
class Fields {
 public:
  Fields(const Options& options, const SurfaceMesh& mesh, double persistence)
      : options_(options), mesh_(mesh), persistence_(persistence) {}

  std::optional<Error> needGirth() {
    if (girth.has_value()) return std::nullopt;
    auto computed = computeGirth(options_.model, mesh_, persistence_, options_.threads);
    if (!computed) return computed.error();
    girth = std::move(computed).value();
    return std::nullopt;
  }
  std::optional<Error> needDiameter() {
    auto computed = computeField(options_.model, mesh_, "sdf", {}, options_.threads);
    if (!computed) return computed.error();
    diameter = std::move(computed).value();
    return std::nullopt;
  }
  std::optional<Error> needThickness() {
    auto computed = computeField(options_.model, mesh_, "thickness", {}, options_.threads);
    if (!computed) return computed.error();
    thickness = std::move(computed).value();
    return std::nullopt;
  }

  std::optional<GirthField> girth;
  std::optional<FieldValues> diameter, thickness;

 private:
  const Options& options_;
  const SurfaceMesh& mesh_;
  double persistence_;
};

Result<PrintCheck> check(const Options& options, const io::LoadedMesh& model, const Wanted& wanted,
                         Fields& fields) {
  const PrintLimits& limits = wanted.limits;
  PrintFields values;
  if (limits.wallThickness > 0) {
    if (auto error = fields.needThickness()) return *std::move(error);
    values.thickness = fields.thickness->values;
  }
  // Before the girth, which takes longer.
  if (auto error = whyNotChecked(model.mesh, values, limits)) return *std::move(error);
  if (limits.tubeDiameter > 0) {
    if (auto error = fields.needGirth()) return *std::move(error);
    values.girth = fields.girth->values;
  }
  return computePrintCheck(options.model, model.mesh, values, limits, options.threads);
}

Result<Parts> divide(const io::LoadedMesh& model, Wanted& wanted, Fields& fields) {
  if (auto error = fields.needDiameter()) return *std::move(error);
  if (auto error = fields.needGirth()) return *std::move(error);
  const std::vector<double>&girth = fields.girth->values, &diameter = fields.diameter->values;
  wanted.parts.thresholds = suggestedThresholds(model.mesh, girth, diameter);
  if (wanted.girth) wanted.parts.thresholds.girth = *wanted.girth;
  if (wanted.shapeDiameter) wanted.parts.thresholds.shapeDiameter = *wanted.shapeDiameter;
  return findParts(model.mesh, girth, diameter, wanted.parts);
}

int run(const Options& options) {
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const io::LoadedMesh& model = loaded.value();
  // The typed lengths are checked before long work.
  auto read = wantedOf(options, model);
  if (!read) return reportError("", read.error());
  Wanted& wanted = read.value();

  Fields fields(options, model.mesh, wanted.persistence);
  PrintCheck checked;
  if (wanted.checks) {
    auto found = check(options, model, wanted, fields);
    if (!found) return reportError(options.model, found.error());
    checked = std::move(found).value();
  }
  const bool writesVertices = options.output.isWanted() && options.output.ending() != ".json";
  Parts parts;
  if (!wanted.checks || writesVertices) {
    auto found = divide(model, wanted, fields);
    if (!found) return reportError(options.model, found.error());
    parts = std::move(found).value();
  }
  const std::string json =
      wanted.checks
          ? io::printCheckJson(model, checked, wanted.limits, options.model, wanted.persistence)
          : io::partsJson(model, parts, wanted.parts, options.model, wanted.persistence);
  if (options.output.isWanted()) {
    const std::string content = writesVertices
                                    ? verticesFor(options, model, *fields.girth, *fields.diameter,
                                                  parts, wanted.persistence)
                                    : json;
    if (auto error = writeOutput(options.output, content)) {
      return reportError(options.output.path, *error);
    }
  }
  if (options.json) {
    std::fputs(json.c_str(), stdout);
  } else if (!hasSummary()) {
    // The exit code reports it.
  } else if (wanted.checks) {
    printCheck(options.model, model, checked, wanted.limits, wanted.persistence);
  } else {
    printParts(options.model, model, parts, wanted.parts, wanted.persistence);
  }
  const bool passes = checked.passes() && !(options.creases && !checked.creases.empty());
  return passes ? 0 : kCheckFails;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  addLengthOption(table, "--girth LENGTH", options->girth,
                  "Tubes have a girth below this length (tau 1)");
  addLengthOption(table, "--shape-diameter LENGTH", options->diameter,
                  "Tubes and plates have a shape diameter below this length (tau 2)")
      .formerly("--thickness");
  table
      .add("--smooth-labels WEIGHT", options->smoothing,
           "Weight of all neighbours of a vertex against its own kind, 0 by default")
      .range(0, 1e6)
      .formerly("--smooth");
  addLengthOption(table, "--min-tube LENGTH", options->minTube,
                  "List tubes thinner than this diameter, as in 3mm; ends with 4 if there are any");
  addLengthOption(table, "--min-wall LENGTH", options->minWall,
                  "List walls thinner than this, as in 1mm; ends with 4 if there are any");
  addLengthOption(
      table, "--min-gap LENGTH", options->minGap,
      "List gaps between facing surfaces narrower than this, as in 0.5mm; ends with 4 likewise");
  table.add("--creases", options->creases,
            "End with 4 for creases, too: sharp edges, faces that touch, slivers");
  addOutputOptions(table, options->output, {".json", ".csv", ".ply"},
                   "Write the answer: .json, or every vertex with its part: .csv, .ply");
  addPositionsOption(table, options->positions);
  addPersistenceOption(table, options->persistence);
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth parts chair.glb -o parts.json",
                "Tubes, plates and body, by thresholds that the model's own values suggest.");
  table.example("girth parts part.stl --unit mm --min-tube 3mm --min-wall 1mm",
                "What is too thin to print; ends with 4 if anything is.");
  table.note("What is checked",
             "Walls: the diameter of the largest ball inside that touches the surface, at the "
             "vertices and within the faces. Gaps: the same outside. Tubes, up to a girth of 2 pi "
             "times the limit: the least width of the section inside the loop, and girth / pi. "
             "Creases are listed apart and do not fail: edges sharper than 75 degrees that end at "
             "thick material, faces that touch, and slivers. Nothing else is passed that is "
             "thinner than its "
             "limit by more than a millionth; overhangs, strength and what the surface does not "
             "show are not looked at. With --persistence, tubes are not either that stand out no "
             "farther than it.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace parts_command

const Command kParts{"parts", "Find tubes and plates, or what is too thin to print",
                     parts_command::add};

}  // namespace girth::cli
