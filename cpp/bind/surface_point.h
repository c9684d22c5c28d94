// Points of a surface as JavaScript passes them.
#pragma once

#include <emscripten/val.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "boundary.h"
#include "girth/surface_point.h"

namespace girth::bind {

/// `SurfacePoint` of types.ts: a vertex, or a face with weights.
inline SurfacePoint pointOf(const emscripten::val& point) {
  if (point.isNumber()) return SurfacePoint::atVertex(Vertex(indexOf(point.as<double>())));
  const emscripten::val weights = point["weights"];
  return SurfacePoint::inFace(
      Face(indexOf(point["face"].as<double>())),
      {weights[0].as<double>(), weights[1].as<double>(), weights[2].as<double>()});
}

/// The points of `SurfacePoint[]`.
inline std::vector<SurfacePoint> curveOf(const emscripten::val& points) {
  std::vector<SurfacePoint> curve;
  for (unsigned k = 0; k < points["length"].as<unsigned>(); ++k) {
    curve.push_back(pointOf(points[k]));
  }
  return curve;
}

/// A point that `beside` gave of a point of an edge is that point again, to the bit.
inline SurfacePoint onEdgeAgain(const SurfacePoint& given) {
  if (given.kind != SurfacePoint::Kind::InFace) return given;
  const std::array<double, 3>& shares = given.weights;
  for (Index corner = 0; corner < 3; ++corner) {
    if (shares[(corner + 2) % 3] != 0) continue;
    const Halfedge side = SurfaceMesh::side(given.face(), corner);
    return {SurfacePoint::Kind::OnEdge, side, {shares[corner], shares[(corner + 1) % 3], 0}};
  }
  return given;
}

/// A `SurfacePoint` of types.ts that C++ gave, again.
inline SurfacePoint pointAgain(const emscripten::val& point) { return onEdgeAgain(pointOf(point)); }

/// A point that is no vertex as barycentric coordinates; of an edge, those of the face beside it.
inline SurfacePoint beside(const SurfacePoint& point) {
  const Halfedge h = point.halfedge();
  if (h == Halfedge::none) return point;
  const Face face = SurfaceMesh::faceOf(h);
  const auto corner = static_cast<std::size_t>(h - SurfaceMesh::side(face, 0));
  std::array<double, 3> shares{};
  shares[corner] = point.weights[0];
  shares[(corner + 1) % 3] = point.weights[1];
  return SurfacePoint::inFace(face, shares);
}

/// `SurfacePoint` of types.ts of a point of an edge: the face beside it, with weights.
inline emscripten::val faceWithWeights(const SurfacePoint& point) {
  const SurfacePoint inside = beside(point);
  emscripten::val weights = emscripten::val::array();
  for (std::size_t i = 0; i < 3; ++i) weights.set(static_cast<unsigned>(i), inside.weights[i]);
  emscripten::val place = emscripten::val::object();
  place.set("face", Index{inside.face()});
  place.set("weights", weights);
  return place;
}

/// `SurfacePoint` of types.ts: a vertex, or a face with weights.
inline emscripten::val surfacePointOf(const SurfacePoint& point) {
  if (point.vertex() == Vertex::none) return faceWithWeights(point);
  return emscripten::val(Index{point.vertex()});
}

/// Many points as one Float64Array, which is quick to make: for each its face and its weights, or a
/// vertex and three NaN (`unpackedPoints` of surface-point.ts).
inline emscripten::val packedPoints(std::span<const SurfacePoint> points) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> numbers;
  numbers.reserve(4 * points.size());
  for (const SurfacePoint& point : points) {
    if (point.vertex() != Vertex::none) {
      numbers.insert(numbers.end(), {static_cast<double>(point.vertex()), kNone, kNone, kNone});
      continue;
    }
    const SurfacePoint inside = beside(point);
    const auto& [a, b, c] = inside.weights;
    numbers.insert(numbers.end(), {static_cast<double>(inside.face()), a, b, c});
  }
  return copyOut<double>("Float64Array", numbers);
}

/// The points that `packedPoints` packed, again.
inline std::vector<SurfacePoint> unpackedPoints(const emscripten::val& packed) {
  const auto numbers = copyIn<double>(packed);
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i + 4 <= numbers.size(); i += 4) {
    const Index number = indexOf(numbers[i]);
    points.push_back(std::isnan(numbers[i + 1])
                         ? SurfacePoint::atVertex(Vertex(number))
                         : onEdgeAgain(SurfacePoint::inFace(
                               Face(number), {numbers[i + 1], numbers[i + 2], numbers[i + 3]})));
  }
  return points;
}

}  // namespace girth::bind
