// Points of a surface as callers give them.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "girth/error.h"
#include "girth/surface_point.h"

namespace girth {

/// VERTEX_OUT_OF_RANGE, or INVALID_POINT: no such halfedge or face; weights that are negative, not
/// numbers, or do not add up to 1 within a millionth.
inline std::optional<Error> checkPoint(const SurfaceMesh& mesh, const SurfacePoint& point) {
  using Kind = SurfacePoint::Kind;
  const auto absent = [&](ErrorCode code, const char* what, Index count) {
    return makeError(code, point.element,
                     std::string("there is no ") + what + " " + std::to_string(point.element) +
                         " among " + std::to_string(count));
  };
  if (point.kind == Kind::AtVertex) {
    if (point.element < mesh.vertexCount()) return std::nullopt;
    return absent(ErrorCode::VertexOutOfRange, "vertex", mesh.vertexCount());
  }
  if (point.kind == Kind::OnEdge && point.element >= mesh.halfedgeCount()) {
    return absent(ErrorCode::InvalidPoint, "halfedge", mesh.halfedgeCount());
  }
  if (point.kind == Kind::InFace && point.element >= mesh.faceCount()) {
    return absent(ErrorCode::InvalidPoint, "face", mesh.faceCount());
  }
  double sum = 0;
  bool valid = point.kind != Kind::OnEdge || point.weights[2] == 0;
  for (const double w : point.weights) {
    valid = valid && w >= -1e-6;  // false where w is not a number
    sum += w;
  }
  if (valid && std::fabs(sum - 1) <= 1e-6) return std::nullopt;
  return makeError(ErrorCode::InvalidPoint, point.element,
                   "the weights of the point are not shares that add up to 1");
}

}  // namespace girth
