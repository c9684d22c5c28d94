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

  bool operator==(const FieldRequest& other) const {
    return name == other.name && shapeDiameter.coneAngle == other.shapeDiameter.coneAngle &&
           shapeDiameter.rays == other.shapeDiameter.rays &&
           thickness.sharpAngle == other.thickness.sharpAngle && distances == other.distances;
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
                                                            : DistanceMethod::FastMarching};
}

/// A function with lengths and their kinds, or with plain numbers.
using AnyFunction = std::variant<VertexFunction<GirthValue>, VertexFunction<double>>;

inline Result<AnyFunction> functionOf(const SurfaceMesh& mesh, const FieldRequest& request) {
  if (request.name == "igf") return AnyFunction(girthFunction(mesh));
  if (request.name == "angle") return AnyFunction(loopAngleFunction(mesh));
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

/// Values as JavaScript receives them. Only the girth has `kinds`.
struct ValueArrays {
  std::vector<double> values;
  std::vector<std::uint8_t> kinds;

  void add(double value) { values.push_back(value); }
  void add(const GirthValue& girth) {
    values.push_back(girth.length);
    kinds.push_back(static_cast<std::uint8_t>(girth.kind));
  }
  void setIn(emscripten::val& object) const {
    object.set("values", copyOut<double>("Float64Array", values));
    object.set("kinds", copyOut<std::uint8_t>("Uint8Array", kinds));
  }
};

}  // namespace girth::bind
