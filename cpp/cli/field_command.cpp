#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "commands.h"
#include "compute.h"
#include "files.h"
#include "girth/geodesic_extent.h"
#include "girth/io/json_text.h"
#include "girth/io/number_text.h"
#include "girth/io/write_field.h"
#include "interrupt.h"
#include "progress_line.h"
#include "report.h"

namespace girth::cli {
namespace {

/// A field with its own memory.
struct ComputedField {
  std::string name, method;
  std::vector<double> values;
};

Result<ComputedField> compute(const FieldOptions& options, const SurfaceMesh& mesh,
                              const std::atomic<bool>& interrupted) {
  const Error stopped = makeError(ErrorCode::Cancelled, -1, "stopped before it was finished");
  if (options.field == "sdf") {
    const ShapeDiameterOptions sdf{options.coneDegrees * std::numbers::pi / 180, options.rays};
    auto field = computeDiameter(options.model, mesh, sdf, options.threads, interrupted);
    if (!field) return field.error();
    return ComputedField{"sdf", io::methodText(sdf), std::move(field.value().values)};
  }
  ExecutionContext context;
  context.threads = options.threads;
  context.cancel = &interrupted;
  ProgressLine progress(options.model);
  context.onProgress = [&](double fraction) { progress.show(fraction); };
  const DistanceMethod distances =
      options.exactDistances ? DistanceMethod::Exact : DistanceMethod::FastMarching;
  GeodesicExtent extent = geodesicExtent(mesh, distances, context);
  if (!extent.complete) return stopped;
  return ComputedField{
      options.field, std::string(io::toString(distances)),
      options.field == "geoaverage" ? std::move(extent.average) : std::move(extent.farthest)};
}

Result<std::string> contentFor(const std::string& extension, const std::string& model,
                               const io::LoadedMesh& loaded, const io::VertexField& field) {
  const std::array<io::VertexField, 1> fields{field};
  if (extension == ".csv") return io::fieldCsv(loaded, fields);
  if (extension == ".json") return io::fieldJson(loaded, fields, model);
  if (extension == ".npy") return io::fieldNpy(loaded, field);
  if (extension == ".ply") return io::fieldPly(loaded, fields);
  return io::fieldGlb(loaded, fields);
}

void print(const FieldOptions& options, const io::LoadedMesh& loaded, const ComputedField& field) {
  std::vector<double> values;
  std::copy_if(field.values.begin(), field.values.end(), std::back_inserter(values),
               [](double value) { return !std::isnan(value); });
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  const double median = n == 0 ? 0 : (values[(n - 1) / 2] + values[n / 2]) / 2;
  if (options.json) {
    const auto number = [&](double value) {
      return n == 0 ? std::string("null") : io::formatNumber(value);
    };
    const std::string text =
        "{\"file\":" + io::jsonString(options.model) +
        ",\"field\":" + io::jsonString(options.field) +
        ",\"method\":" + io::jsonString(field.method) + ",\"unit\":" + io::jsonString(loaded.unit) +
        ",\"vertices\":" + std::to_string(field.values.size()) +
        ",\"withValue\":" + std::to_string(n) + ",\"min\":" + number(n == 0 ? 0 : values.front()) +
        ",\"median\":" + number(median) + ",\"max\":" + number(n == 0 ? 0 : values.back()) + "}\n";
    std::fputs(text.c_str(), stdout);
    return;
  }
  std::printf("%s: %s (%s) at %zu of %zu vertices\n", options.model.c_str(), options.field.c_str(),
              field.method.c_str(), n, field.values.size());
  if (n == 0) return;
  std::printf("  min %s, median %s, max %s%s\n", readable(values.front()).c_str(),
              readable(median).c_str(), readable(values.back()).c_str(),
              unitSuffix(loaded.unit).c_str());
}

}  // namespace

int runField(const FieldOptions& options) {
  const std::string extension = extensionOf(options.output);
  if (!options.output.empty()) {
    constexpr std::array<const char*, 5> kEndings{".csv", ".json", ".npy", ".ply", ".glb"};
    if (std::find(kEndings.begin(), kEndings.end(), extension) == kEndings.end()) {
      Error error = makeError(ErrorCode::Usage, -1, "the output's name has no known ending");
      error.hint = "use .csv, .json, .npy, .ply or .glb";
      return reportError(options.output, error);
    }
    if (auto error = checkWritable(options.output)) return reportError(options.output, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const auto field = compute(options, loaded.value().mesh, catchInterrupts());
  if (!field) return reportError(options.model, field.error());
  if (!options.output.empty()) {
    const io::VertexField written{
        field.value().name, field.value().values, loaded.value().unit, field.value().method, {}};
    const auto content = contentFor(extension, options.model, loaded.value(), written);
    if (!content) return reportError(options.output, content.error());
    if (auto error = writeFile(options.output, content.value())) {
      return reportError(options.output, *error);
    }
  }
  print(options, loaded.value(), field.value());
  return 0;
}

}  // namespace girth::cli
