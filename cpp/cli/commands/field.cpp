// girth field: another field than the girth, at every vertex.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/fields.h"
#include "girth/io/json_text.h"
#include "girth/io/write_field.h"
#include "girth/persistent_maxima.h"
#include "model/computing.h"
#include "model/loading.h"
#include "model/persistence.h"
#include "model/spectral_field.h"
#include "model/typed_point.h"
#include "process/output.h"
#include "process/report.h"
#include "text/number_text.h"

namespace girth::cli {
namespace field_command {
namespace {

struct Options {
  std::string model;
  ModelOptions preparing;
  /// One of `fields()`, but the girth.
  std::string name;
  Output output;
  unsigned threads{0};
  bool json{false};
  FieldOptions field;
  /// Parameters as they were typed, whose values depend on the model: each is read once it is
  /// loaded.
  std::vector<std::function<std::optional<Error>(const io::LoadedMesh&)>> ofModel;
  SpectralFieldOptions spectral;
  /// How many of the most persistent maxima to list.
  std::uint32_t maxima{0};
  bool positions{false};
};

/// The fields of this command.
std::vector<FieldInfo> offered() {
  std::vector<FieldInfo> found(fields().begin(), fields().end());
  std::erase_if(found, [](const FieldInfo& one) { return one.name == "igf"; });
  return found;
}

/// Something of each of them, in one text.
std::string listed(const std::function<std::string(const FieldInfo&)>& words,
                   std::string_view between) {
  std::string text;
  for (const FieldInfo& one : offered()) {
    if (!text.empty()) text += between;
    text += words(one);
  }
  return text;
}

Result<std::vector<ComputedField>> compute(const Options& options, const io::LoadedMesh& loaded) {
  const SurfaceMesh& mesh = loaded.mesh;
  const FieldInfo& info = *findField(options.name);
  const std::string unit = unitText(info.unit, loaded.unit);
  if (info.isSpectral) {
    return computeSpectralField(options.name, options.spectral, options.model, mesh, unit);
  }
  const FieldOptions& given = options.field;
  if (options.name == "angle") noteLargeSurface(options.model, mesh, kRemeshFirst);
  for (const auto& read : options.ofModel) {
    if (auto error = read(loaded)) return *std::move(error);
  }
  auto field = computeField(options.model, mesh, options.name, given, options.threads);
  if (!field) return field.error();
  return std::vector<ComputedField>{
      {options.name, io::methodText(options.name, given), unit, std::move(field.value().values)}};
}

Result<std::string> contentFor(const Options& options, const io::LoadedMesh& loaded,
                               const std::vector<ComputedField>& computed) {
  std::vector<io::VertexField> fields;
  for (const ComputedField& field : computed) {
    fields.push_back({field.name, field.values, field.unit, field.method, {}});
  }
  const std::string format = options.output.ending().substr(1);
  if (format == "npy" && fields.size() > 1) {
    return usageError("NPY holds one number for each vertex here",
                      "choose one with --only, or use .csv, .json, .ply or .glb");
  }
  return io::fieldFile(loaded, fields, format, options.model, columnsOf(options.positions));
}

/// The number of a vertex in the file; -1 where it was made here.
std::int64_t inFile(const io::LoadedMesh& loaded, Index vertex) {
  const Index input = loaded.inputOfVertex[vertex];
  return input == kNoIndex ? -1 : static_cast<std::int64_t>(input);
}

std::string maximaJson(const io::LoadedMesh& loaded, const std::vector<PersistentMaximum>& maxima) {
  io::JsonList list;
  for (const PersistentMaximum& maximum : maxima) {
    list.add(io::JsonObject()
                 .add("vertex", inFile(loaded, maximum.vertex))
                 .add("value", maximum.value)
                 .add("persistence", maximum.persistence)
                 .text());
  }
  return list.text();
}

void printMaxima(const io::LoadedMesh& loaded, const std::vector<PersistentMaximum>& maxima) {
  std::printf("  %7s %12s %12s  %s\n", "maximum", "value", "persistence", "vertex");
  for (std::size_t i = 0; i < maxima.size(); ++i) {
    std::printf("  %7zu %12s %12s  %s\n", i, readable(maxima[i].value).c_str(),
                readable(maxima[i].persistence).c_str(),
                numberInFile(loaded, maxima[i].vertex).c_str());
  }
}

/// The unit behind a value in the summary.
std::string unitOf(const std::string& field, const std::string& unit) {
  const FieldUnit kind = findField(field)->unit;
  if (kind == FieldUnit::Radian) return " rad";
  return kind == FieldUnit::Length ? unitSuffix(unit) : "";
}

void print(const Options& options, const io::LoadedMesh& loaded,
           const std::vector<ComputedField>& fields, const std::vector<PersistentMaximum>& maxima) {
  std::vector<double> values;
  for (const ComputedField& field : fields) {
    std::copy_if(field.values.begin(), field.values.end(), std::back_inserter(values),
                 [](double value) { return !std::isnan(value); });
  }
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  const double median = n == 0 ? 0 : (values[(n - 1) / 2] + values[n / 2]) / 2;
  const ComputedField& first = fields[0];
  if (options.json) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    io::JsonObject json;
    json.add("file", options.model)
        .add("field", options.name)
        .add("method", first.method)
        .add("unit", first.unit)
        .add("components", fields.size())
        .add("vertices", first.values.size())
        .add("withValue", n / fields.size())
        .add("min", n == 0 ? kNone : values.front())
        .add("median", n == 0 ? kNone : median)
        .add("max", n == 0 ? kNone : values.back());
    if (options.maxima > 0) json.addJson("maxima", maximaJson(loaded, maxima));
    std::puts(json.text().c_str());
    return;
  }
  if (!hasSummary()) return;
  const std::string components =
      fields.size() == 1 ? "" : std::to_string(fields.size()) + " components ";
  std::printf("%s: %s (%s) %sat %zu of %zu vertices\n", options.model.c_str(), options.name.c_str(),
              first.method.c_str(), components.c_str(), n / fields.size(), first.values.size());
  if (n == 0) return;
  std::printf("  min %s, median %s, max %s%s\n", readable(values.front()).c_str(),
              readable(median).c_str(), readable(values.back()).c_str(),
              unitOf(options.name, first.unit).c_str());
  if (options.maxima > 0) printMaxima(loaded, maxima);
}

int run(const Options& options) {
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const auto fields = compute(options, loaded.value());
  if (!fields) return reportError(options.model, fields.error());
  std::vector<PersistentMaximum> maxima;
  if (options.maxima > 0) {
    if (fields.value().size() > 1) {
      return reportError(
          "", usageError("maxima need one number for each vertex", "choose one with --only"));
    }
    auto found = persistentMaxima(loaded.value().mesh, fields.value()[0].values);
    if (!found) return reportError(options.model, found.error());
    maxima = std::move(found).value();
    maxima.resize(std::min<std::size_t>(maxima.size(), options.maxima));
  }
  if (options.output.isWanted()) {
    if (auto error =
            writeResult(options.output, contentFor(options, loaded.value(), fields.value()))) {
      return reportError(options.output.path, *error);
    }
  }
  print(options, loaded.value(), fields.value(), maxima);
  return 0;
}

/// A parameter of the table of fields.
struct Parameter {
  std::string keyword, value, fields, words;
  double least, greatest;

  /// The fields of this command that have it.
  std::vector<std::string> ofFields() const {
    std::istringstream listed(fields);
    std::vector<std::string> found{std::istream_iterator<std::string>(listed), {}};
    std::erase(found, "igf");
    return found;
  }
  std::string declaration() const { return "--" + keyword + (value.empty() ? "" : " ") + value; }
  /// "sdf: rays from each vertex; 30 by default"
  std::string text(const std::string& byDefault) const {
    std::string text;
    for (const char c : fields) text += c == ' ' ? std::string(", ") : std::string(1, c);
    return text + ": " + words + (byDefault.empty() ? "" : "; " + byDefault + " by default");
  }
};
// The kinds of the table.
struct Count;
struct Degrees;
struct Length;
struct Method;
struct Persistence;
struct Points;
/// One of a kind.
template <class Kind>
struct Taken : Parameter {};

void addParameter(OptionTable& table, const Taken<Count>& of, unsigned& member, Options&) {
  table.add(of.declaration(), member, of.text(std::to_string(member)))
      .range(of.least, of.greatest)
      .onlyFor("--field", of.ofFields());
}
void addParameter(OptionTable& table, const Taken<Degrees>& of, double& member, Options&) {
  // Radians cannot hold most degrees exactly.
  const double usual = std::round(1e6 * member * 180 / std::numbers::pi) / 1e6;
  const auto store = [&member](const std::string& text) {
    const auto degrees = io::parseNumber(text);
    if (!degrees) return "\"" + text + "\" is no number";
    member = *degrees * std::numbers::pi / 180;
    return std::string();
  };
  table.onValue(of.declaration(), store, of.text(io::formatNumber(usual) + " degrees"))
      .range(of.least, of.greatest)
      .onlyFor("--field", of.ofFields());
}
void addParameter(OptionTable& table, const Taken<Method>& of, DistanceMethod& member, Options&) {
  table
      .onFlag(
          of.declaration(), [&member] { member = DistanceMethod::Exact; }, of.text(""))
      .onlyFor("--field", of.ofFields());
}
void addParameter(OptionTable& table, const Taken<Persistence>& of, double& member,
                  Options& options) {
  const auto typed = std::make_shared<std::string>();
  addPersistenceOption(table, *typed, "angle").onlyFor("--field", of.ofFields());
  options.ofModel.emplace_back(
      [typed, &member](const io::LoadedMesh& loaded) -> std::optional<Error> {
        const auto persistence = persistenceOf(*typed, loaded);
        if (!persistence) return persistence.error();
        member = persistence.value();
        return std::nullopt;
      });
}
void addParameter(OptionTable& table, const Taken<Length>& of, double& member, Options& options) {
  const auto typed = std::make_shared<std::string>();
  addLengthOption(table, of.declaration(), *typed, of.text("")).onlyFor("--field", of.ofFields());
  options.ofModel.emplace_back([typed, &member](const io::LoadedMesh& loaded) {
    return readLength(*typed, loaded.unit, member);
  });
}
void addParameter(OptionTable& table, const Taken<Points>& of, std::vector<SurfacePoint>& member,
                  Options& options) {
  const auto typed = std::make_shared<std::vector<TypedPoint>>();
  const auto store = [typed](const std::string& text) { return readPoints(text, *typed); };
  table.onValue(of.declaration(), store, of.text("the first vertex"))
      .onlyFor("--field", of.ofFields());
  options.ofModel.emplace_back(
      [typed, &member, &options](const io::LoadedMesh& loaded) -> std::optional<Error> {
        const auto points = surfacePoints(loaded, *typed, options.model, options.preparing);
        if (!points) return points.error();
        member.insert(member.end(), points.value().begin(), points.value().end());
        return std::nullopt;
      });
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  const auto nameOf = [](const FieldInfo& one) { return std::string(one.name); };
  std::vector<std::string> names;
  for (const FieldInfo& one : offered()) names.push_back(nameOf(one));
  table.add("--field NAME", options->name, listed(nameOf, ", ")).required().oneOf(std::move(names));
  addOutputOptions(table, options->output, {".csv", ".json", ".npy", ".ply", ".glb"},
                   "Write the values: .csv, .json, .npy, .ply or .glb");
#define GIRTH_FIELD_PARAMETER(keyword, value, fields, kind, member, least, greatest, words) \
  addParameter(table, Taken<kind>{{#keyword, value, fields, words, least, greatest}},       \
               options->field.member, *options);
#include "girth/fields.def"
  addSpectralFieldOptions(table, options->spectral);
  table
      .add("--maxima N", options->maxima,
           "Number of maxima to list, the most persistent first; with hks: persistent heat maxima")
      .range(1, 1'000'000);
  addPositionsOption(table, options->positions);
  addSubdivideOption(table, options->preparing);
  addModelOptions(table, options->preparing);
  addThreadsOption(table, options->threads);
  table.add("--json", options->json, "Print the summary as JSON");
  const auto meaningOf = [](const FieldInfo& one) {
    return std::string(one.name) + ": " + std::string(one.meaning);
  };
  table.note("Fields", listed(meaningOf, "; ") + ".");
  table.note(
      "Which field",
      "thickness measures walls and plates, never more than there is; sdf is a mean, smoother, for "
      "comparing shapes and for parts. geoaverage measures how central a place is, geofarthest how "
      "far the farthest place is. angle is pi where the loop is a closed geodesic. hks, sihks and "
      "wks compare shapes however they are bent. With 9,000 triangles one processor took 0.05 s "
      "for sdf, 1.4 s for angle, 2.3 s for the signatures, 7.7 s for geoaverage and geofarthest.");
  table.example("girth field model.glb --field thickness -o thickness.csv",
                "How thick the body is at every vertex.");
  table.example(
      "girth field model.glb --field distance --from 12,88 -o distance.csv",
      "The distance of each vertex from the nearer of two points; --from points.csv reads them.");
  table.example("girth field model.glb --field hks --maxima 10",
                "The ten most persistent maxima of the heat kernel signature.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace field_command

const Command kField{"field", "Compute another field: thickness, centricity, ...",
                     field_command::add};

}  // namespace girth::cli
