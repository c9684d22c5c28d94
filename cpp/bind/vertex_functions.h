// Vertex fields by the requests of JavaScript.
#pragma once

#include <emscripten/val.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "boundary.h"
#include "girth/geodesic_extent.h"
#include "girth/girth_field.h"
#include "girth/shape_diameter.h"
#include "girth/thickness.h"

namespace girth::bind {

/// `FieldRequest` of protocol.ts.
struct FieldRequest {
  std::string name;
  ShapeDiameterOptions shapeDiameter;
  ThicknessOptions thickness;
  DistanceMethod distances{DistanceMethod::FastMarching};
  /// Of the girth and its angle: tau, in model units. Of barcodes: up to which persistence.
  double persistence{0};

  bool operator==(const FieldRequest& other) const {
    return name == other.name && shapeDiameter.coneAngle == other.shapeDiameter.coneAngle &&
           shapeDiameter.rays == other.shapeDiameter.rays &&
           thickness.sharpAngle == other.thickness.sharpAngle && distances == other.distances &&
           persistence == other.persistence;
  }
};

inline FieldRequest requestOf(const emscripten::val& request) {
  // A number that is no count becomes 0, which the core refuses.
  const double rays = request["rays"].as<double>();
  const bool isCount = rays >= 0 && rays < 1e9;
  return {request["name"].as<std::string>(),
          {request["coneAngle"].as<double>(), isCount ? static_cast<unsigned>(rays) : 0},
          {request["sharpAngle"].as<double>(), ThicknessSide::Inside},
          request["distances"].as<std::string>() == "exact" ? DistanceMethod::Exact
                                                            : DistanceMethod::FastMarching,
          request["persistence"].as<double>()};
}

/// A function with lengths and their kinds, with plain numbers, or with barcodes.
using AnyFunction =
    std::variant<VertexFunction<GirthValue>, VertexFunction<double>, VertexFunction<Barcode>>;

inline Result<AnyFunction> functionOf(const SurfaceMesh& mesh, const FieldRequest& request) {
  if (auto error = checkPersistence(request.persistence)) return *std::move(error);
  const double persistence = request.persistence;
  if (request.name == "igf") {
    return AnyFunction(girthFunction(mesh, {GirthMethod::Exact, persistence}));
  }
  if (request.name == "angle") return AnyFunction(loopAngleFunction(mesh, persistence));
  if (request.name == "barcode") return AnyFunction(barcodeFunction(mesh, {persistence}));
  if (request.name == "sdf") {
    auto function = shapeDiameterFunction(mesh, request.shapeDiameter);
    if (!function) return function.error();
    return AnyFunction(std::move(function).value());
  }
  if (request.name == "thickness") {
    auto function = medialThicknessFunction(mesh, request.thickness);
    if (!function) return function.error();
    return AnyFunction(std::move(function).value());
  }
  if (request.name == "geoaverage") {
    return AnyFunction(geodesicExtentFunction(mesh, ExtentMeasure::Average, request.distances));
  }
  if (request.name == "geofarthest") {
    return AnyFunction(geodesicExtentFunction(mesh, ExtentMeasure::Farthest, request.distances));
  }
  return makeError(ErrorCode::Usage, -1, "there is no field '" + request.name + "'");
}

/// Values as JavaScript receives them (`PartialField` of types.ts). Only the girth has `kinds`. Of
/// barcodes the values are those of the rest, with how many bars each has, and births and deaths in
/// turn.
struct ValueArrays {
  std::vector<double> values;
  std::vector<std::uint8_t> kinds;
  std::vector<Index> counts;
  std::vector<double> bars;

  void add(double value) { values.push_back(value); }
  void add(const GirthValue& girth) {
    values.push_back(girth.length);
    kinds.push_back(static_cast<std::uint8_t>(girth.kind));
  }
  void add(const Barcode& barcode) {
    add(barcode.rest);
    counts.push_back(static_cast<Index>(barcode.bars.size()));
    for (const SaddleBar& bar : barcode.bars) bars.insert(bars.end(), {bar.birth, bar.death});
  }
  void setIn(emscripten::val& object) const {
    object.set("values", copyOut<double>("Float64Array", values));
    object.set("kinds", copyOut<std::uint8_t>("Uint8Array", kinds));
    if (counts.empty()) return;
    object.set("counts", copyOut<Index>("Uint32Array", counts));
    object.set("bars", copyOut<double>("Float64Array", bars));
  }
};

}  // namespace girth::bind
