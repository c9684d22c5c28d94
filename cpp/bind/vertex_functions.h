// Vertex fields by the requests of JavaScript.
#pragma once

#include <emscripten/val.h>

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "boundary.h"
#include "girth/fields.h"
#include "girth/girth_field.h"
#include "surface_point.h"

namespace girth::bind {

/// Whether a parameter has the same value.
template <class Value>
bool isSame(const Value& one, const Value& other) {
  return one == other;
}
inline bool isSame(const std::vector<SurfacePoint>& one, const std::vector<SurfacePoint>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const SurfacePoint& a, const SurfacePoint& b) {
                      return a.kind == b.kind && a.element == b.element && a.weights == b.weights;
                    });
}

/// `FieldRequest` of protocol.ts.
struct FieldRequest {
  /// One of `fields()`, or "barcode", whose persistence is the greatest that counts.
  std::string name;
  FieldOptions options;

  bool operator==(const FieldRequest& other) const {
#define GIRTH_FIELD_PARAMETER(keyword, value, fields, kind, member, least, greatest, words) \
  if (!isSame(options.member, other.options.member)) return false;
#include "girth/fields.def"
    return name == other.name;
  }
};

/// Takes a parameter that is given. A number that is no count becomes 0, which the core refuses.
inline void take(const emscripten::val& given, double& parameter) {
  parameter = given.as<double>();
}
inline void take(const emscripten::val& given, unsigned& parameter) {
  const double number = given.as<double>();
  parameter = number >= 0 && number < 1e9 ? static_cast<unsigned>(number) : 0;
}
inline void take(const emscripten::val& given, DistanceMethod& parameter) {
  parameter =
      given.as<std::string>() == "exact" ? DistanceMethod::Exact : DistanceMethod::FastMarching;
}

inline void take(const emscripten::val& given, std::vector<SurfacePoint>& parameter) {
  parameter = curveOf(given);
}

inline FieldRequest requestOf(const emscripten::val& given) {
  FieldRequest request{given["name"].as<std::string>(), {}};
#define GIRTH_FIELD_PARAMETER(keyword, value, fields, kind, member, least, greatest, words) \
  if (const auto one = given[#member]; !one.isUndefined()) take(one, request.options.member);
#include "girth/fields.def"
  return request;
}

/// A function with lengths and their kinds, with plain numbers, or with barcodes.
using AnyFunction =
    std::variant<VertexFunction<GirthValue>, VertexFunction<double>, VertexFunction<Barcode>>;

inline Result<AnyFunction> functionOf(const SurfaceMesh& mesh, const FieldRequest& request) {
  if (request.name == "barcode") {
    const double persistence = request.options.persistence;
    if (auto error = checkPersistence(persistence)) return *std::move(error);
    return AnyFunction(barcodeFunction(mesh, {persistence}));
  }
  const auto function = fieldFunction(mesh, request.name, request.options);
  if (!function) return function.error();
  return std::visit([](const auto& one) { return AnyFunction(one); }, function.value());
}

/// Values as JavaScript receives them (`PartialField` of types.ts). Only the girth has `kinds`. The
/// values of barcodes are those of the rest, with how many bars each has, and births and deaths in
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
