#include "girth/study/study_fields.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

#include "girth/girth_field.h"
#include "girth/remesh.h"
#include "girth/smooth_surface.h"
#include "girth/study/surface_changes.h"
#include "girth/vertex_areas.h"
#include "mesh/mesh_arrays.h"
#include "mesh/vector.h"

namespace girth::study {

namespace {

constexpr Index kVerticesPerPair = 5, kLeastPairs = 10;

Error stopped() { return makeError(ErrorCode::Cancelled, -1, "stopped before it was finished"); }

/// The mesh's triangles on positions multiplied by `factor`.
Result<SurfaceMesh> scaled(const SurfaceMesh& mesh, double factor) {
  std::vector<Vec3> positions = positionsOf(mesh);
  for (Vec3& p : positions) p = factor * p;
  return surfaceOf(positions, trianglesOf(mesh));
}

Result<std::vector<StudyField>> girthOf(const SurfaceMesh& surface, const GirthOptions& options,
                                        const char* name, const ExecutionContext& context) {
  if (auto error = checkPersistence(options.persistence)) return *std::move(error);
  GirthField field = girthField(surface, options, context);
  if (!field.complete()) return stopped();
  return std::vector<StudyField>{{name, 1, std::move(field.values)}};
}

StudyField fieldOf(const char* name, VertexSignatures signatures) {
  return {name, signatures.dimensions, std::move(signatures.values)};
}

/// Every time's values over their mean.
void divideByMeans(VertexSignatures& signatures, const std::vector<double>& areas) {
  const std::size_t dimensions = signatures.dimensions;
  std::vector<double> means(dimensions, 0);
  double area = 0;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    area += areas[v];
    for (std::size_t d = 0; d < dimensions; ++d) {
      means[d] += areas[v] * signatures.values[v * dimensions + d];
    }
  }
  for (std::size_t i = 0; i < signatures.values.size(); ++i) {
    signatures.values[i] /= means[i % dimensions] / area;
  }
}

Result<std::vector<StudyField>> spectralFields(const SurfaceMesh& surface,
                                               const FieldParameters& parameters,
                                               const ExecutionContext& context) {
  constexpr std::size_t kTimes = 16;
  SpectrumOptions options = parameters.spectrum;
  options.pairs =
      std::min(options.pairs, std::max(kLeastPairs, surface.vertexCount() / kVerticesPerPair));
  const auto spectrum = laplaceSpectrum(surface, options, context);
  if (!spectrum) return spectrum.error();
  std::vector<double> times;
  for (std::size_t i = 0; i < kTimes; ++i) {
    const double share = static_cast<double>(i) / (kTimes - 1);
    times.push_back(surface.area() * std::log(10.0) / std::numbers::pi *
                    std::pow(300.0, share - 1));
  }
  auto hks = heatKernelSignature(spectrum.value(), times);
  if (!hks) return hks.error();
  divideByMeans(hks.value(), spectrum.value().areas);
  auto sihks = scaleInvariantHeatKernelSignature(spectrum.value(), parameters.sihks);
  if (!sihks) return sihks.error();
  auto wks = waveKernelSignature(spectrum.value(), parameters.wks);
  if (!wks) return wks.error();
  // In units of the surface's own area, so that size does not matter.
  for (double& value : wks.value().values) value *= surface.area();
  std::vector<StudyField> fields;
  fields.push_back(fieldOf("hks", std::move(hks).value()));
  fields.push_back(fieldOf("sihks", std::move(sihks).value()));
  fields.push_back(fieldOf("wks", std::move(wks).value()));
  return fields;
}

Result<std::vector<StudyField>> compute(const SurfaceMesh& surface, FieldGroup group,
                                        const FieldParameters& parameters,
                                        const ExecutionContext& context) {
  switch (group) {
    case FieldGroup::Girth:
      return girthOf(surface,
                     {GirthMethod::Exact, parameters.persistence * std::sqrt(surface.area())},
                     "igf", context);
    case FieldGroup::MarchedGirth:
      return girthOf(surface, {GirthMethod::Marched}, "igf-ms", context);
    case FieldGroup::Diameter: {
      auto field = shapeDiameter(surface, parameters.diameter, context);
      if (!field) return field.error();
      if (!field.value().complete) return stopped();
      return std::vector<StudyField>{{"sdf", 1, std::move(field.value().values)}};
    }
    case FieldGroup::Extent: {
      GeodesicExtent extent = geodesicExtent(surface, parameters.distances, context);
      if (!extent.complete) return stopped();
      std::vector<StudyField> fields(2);
      fields[0] = {"geoaverage", 1, std::move(extent.average)};
      fields[1] = {"geofarthest", 1, std::move(extent.farthest)};
      return fields;
    }
    case FieldGroup::Spectral:
      return spectralFields(surface, parameters, context);
  }
  return makeError(ErrorCode::Internal, -1, "there is no such group of fields");
}

/// All bits, the same in every locale.
std::string exactText(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return std::to_string(bits);
}

}  // namespace

std::string_view toString(FieldGroup group) {
  switch (group) {
    case FieldGroup::Girth:
      return "igf";
    case FieldGroup::MarchedGirth:
      return "igf-ms";
    case FieldGroup::Diameter:
      return "sdf";
    case FieldGroup::Extent:
      return "extent";
    case FieldGroup::Spectral:
      return "spectral";
  }
  return "";
}

const StudyField* StudyFields::find(std::string_view name) const {
  for (const StudyField& field : fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

Result<SurfaceMesh> studySurface(const SurfaceMesh& mesh, const FieldParameters& parameters,
                                 const ExecutionContext& context) {
  std::vector<SurfaceMesh> remeshed;  // one or none, with other triangles or positions
  if (parameters.faces > 0 && mesh.faceCount() > parameters.faces) {
    auto surface = remesh(mesh, {parameters.faces, RemeshMethod::Even}, context);
    if (!surface) return surface.error();
    remeshed.push_back(std::move(surface.value().mesh));
  }
  if (parameters.noise != 0) {
    constexpr std::uint64_t kSeed = 1;
    auto noisy = withNoise(remeshed.empty() ? mesh : remeshed.front(), parameters.noise, kSeed);
    if (!noisy) return noisy.error();
    remeshed.assign(1, std::move(noisy).value());
  }
  if (parameters.smoothing != 0) {
    // Remeshing has said that all is done, and the share never falls.
    auto smooth = smoothSurface(remeshed.empty() ? mesh : remeshed.front(), parameters.smoothing,
                                context.ofOneThread());
    if (!smooth) return smooth.error();
    remeshed.assign(1, std::move(smooth).value());
  }
  const SurfaceMesh& surface = remeshed.empty() ? mesh : remeshed.front();
  if (!parameters.unitArea) return surface;
  const double factor = 1 / std::sqrt(surface.area());
  if (!std::isfinite(factor) || factor == 0) {
    return makeError(ErrorCode::LimitExceeded, -1, "its area cannot be scaled to 1");
  }
  return scaled(surface, factor);
}

Result<StudyFields> studyFields(const SurfaceMesh& surface, FieldGroup group,
                                const FieldParameters& parameters,
                                const ExecutionContext& context) {
  auto fields = compute(surface, group, parameters, context);
  if (!fields) return fields.error();
  StudyFields result{vertexAreas(surface), std::move(fields.value())};
  for (double& weight : result.weights) weight /= surface.area();
  return result;
}

std::string parametersText(FieldGroup group, const FieldParameters& parameters) {
  std::string text = "fields 1 " + std::string(toString(group)) + " faces " +
                     std::to_string(parameters.faces) +
                     (parameters.unitArea ? " area 1" : " own area");
  if (parameters.noise != 0) text += " noise " + exactText(parameters.noise);
  if (parameters.smoothing != 0) text += " smoothing " + std::to_string(parameters.smoothing);
  if (group == FieldGroup::Girth && parameters.persistence != 0) {
    text += " persistence " + exactText(parameters.persistence);
  }
  if (group == FieldGroup::Diameter) {
    text += " cone " + exactText(parameters.diameter.coneRadians) + " rays " +
            std::to_string(parameters.diameter.rays);
  }
  if (group == FieldGroup::Extent) {
    text += parameters.distances == DistanceMethod::Exact ? " exact" : " fast marching";
  }
  if (group == FieldGroup::Spectral) {
    const SihksOptions& sihks = parameters.sihks;
    text += " pairs " + std::to_string(parameters.spectrum.pairs) + " of " +
            std::to_string(kVerticesPerPair) + " sihks";
    for (const double value :
         {sihks.base, sihks.first, sihks.last, sihks.step, sihks.referenceArea}) {
      text += " " + exactText(value);
    }
    text += " " + std::to_string(sihks.frequencies) + " " + std::to_string(sihks.lowestFrequency) +
            " " + std::to_string(sihks.eigenfunctions) + " wks " +
            std::to_string(parameters.wks.energies) + " " + exactText(parameters.wks.variance);
  }
  return text;
}

}  // namespace girth::study
