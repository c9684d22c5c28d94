// Points of a surface as JavaScript passes them.
#pragma once

#include <emscripten/val.h>

#include <array>
#include <cstddef>

#include "girth/surface_point.h"

namespace girth::bind {

/// `SurfacePoint` of types.ts: a vertex, or a face with weights.
inline SurfacePoint pointOf(const emscripten::val& point) {
  if (point.isNumber()) return SurfacePoint::atVertex(Vertex(point.as<Index>()));
  const emscripten::val weights = point["weights"];
  return SurfacePoint::inFace(
      Face(point["face"].as<Index>()),
      {weights[0].as<double>(), weights[1].as<double>(), weights[2].as<double>()});
}

/// `SurfacePoint` of types.ts of a point of an edge: the face beside it, with weights.
inline emscripten::val faceWithWeights(const SurfacePoint& point) {
  Face face = point.face();
  std::array<double, 3> shares = point.weights;
  if (const Halfedge h = point.halfedge(); h != Halfedge::none) {
    face = SurfaceMesh::faceOf(h);
    const auto corner = static_cast<std::size_t>(h - SurfaceMesh::side(face, 0));
    shares = {};
    shares[corner] = point.weights[0];
    shares[(corner + 1) % 3] = point.weights[1];
  }
  emscripten::val weights = emscripten::val::array();
  for (std::size_t i = 0; i < 3; ++i) weights.set(static_cast<unsigned>(i), shares[i]);
  emscripten::val place = emscripten::val::object();
  place.set("face", Index{face});
  place.set("weights", weights);
  return place;
}

/// `SurfacePoint` of types.ts: a vertex, or a face with weights.
inline emscripten::val surfacePointOf(const SurfacePoint& point) {
  if (point.vertex() == Vertex::none) return faceWithWeights(point);
  return emscripten::val(Index{point.vertex()});
}

}  // namespace girth::bind
