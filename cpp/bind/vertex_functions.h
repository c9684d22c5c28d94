// Functions of the vertices as JavaScript asks for them.
#pragma once

#include <emscripten/val.h>

#include <span>
#include <string>
#include <vector>

#include "boundary.h"
#include "girth/geodesic_extent.h"
#include "girth/girth_field.h"
#include "girth/shape_diameter.h"

namespace girth::bind {

/// `FieldRequest` of protocol.ts.
struct FieldRequest {
  std::string name;
  ShapeDiameterOptions shapeDiameter;
  DistanceMethod distances{DistanceMethod::FastMarching};

  bool operator==(const FieldRequest& other) const {
    return name == other.name && shapeDiameter.coneAngle == other.shapeDiameter.coneAngle &&
           shapeDiameter.rays == other.shapeDiameter.rays && distances == other.distances;
  }
};

inline FieldRequest requestOf(const emscripten::val& request) {
  // Numbers that are no counts become one that the core refuses.
  const double rays = request["rays"].as<double>();
  const bool isCount = rays >= 0 && rays < 1e9;
  return {request["name"].as<std::string>(),
          {request["coneAngle"].as<double>(), isCount ? static_cast<unsigned>(rays) : 0},
          request["distances"].as<std::string>() == "exact" ? DistanceMethod::Exact
                                                            : DistanceMethod::FastMarching};
}

inline Result<VertexFunction> functionOf(const SurfaceMesh& mesh, const FieldRequest& request) {
  if (request.name == "igf") return girthFunction(mesh);
  if (request.name == "angle") return loopAngleFunction(mesh);
  if (request.name == "sdf") return shapeDiameterFunction(mesh, request.shapeDiameter);
  if (request.name == "geoaverage") {
    return geodesicExtentFunction(mesh, ExtentMeasure::Average, request.distances);
  }
  if (request.name == "geofarthest") {
    return geodesicExtentFunction(mesh, ExtentMeasure::Farthest, request.distances);
  }
  return makeError(ErrorCode::Usage, -1, "there is no field '" + request.name + "'");
}

/// Only the girth's values have kinds that tell something.
inline std::span<const std::uint8_t> kindsOf(const FieldRequest& request,
                                             std::span<const LoopKind> kinds) {
  if (request.name != "igf") return {};
  return {reinterpret_cast<const std::uint8_t*>(kinds.data()), kinds.size()};
}

}  // namespace girth::bind
