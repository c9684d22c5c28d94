// Surfaces and their points as JavaScript receives them. Points are drawn with 32-bit numbers,
// which are precise only near their origin.
#pragma once

#include <emscripten/val.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "boundary.h"
#include "girth/surface_mesh.h"

namespace girth::bind {

/// The point that drawn points are relative to (`MeshGeometry.origin` of types.ts): 0, 0, 0; for
/// surfaces that lie more than 64 times their size away from it, such as scans of places on Earth,
/// their middle. Linear in the vertices.
inline Vec3 drawingOrigin(const SurfaceMesh& mesh) {
  constexpr double kFar = 64;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec3 low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const Vec3 middle{low.x + (high.x - low.x) / 2, low.y + (high.y - low.y) / 2,
                    low.z + (high.z - low.z) / 2};
  const double away = std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)});
  return away > kFar * size ? middle : Vec3{0, 0, 0};
}

/// x, y, z of each point, relative to the origin, as Float32Array.
inline emscripten::val drawnPoints(std::span<const Vec3> points, const Vec3& origin) {
  std::vector<float> numbers;
  numbers.reserve(3 * points.size());
  for (const Vec3& p : points) {
    for (const double x : {p.x - origin.x, p.y - origin.y, p.z - origin.z}) {
      numbers.push_back(static_cast<float>(x));
    }
  }
  return copyOut<float>("Float32Array", numbers);
}

/// [x, y, z].
inline emscripten::val tripleOf(const Vec3& p) {
  emscripten::val triple = emscripten::val::array();
  triple.set(0, p.x);
  triple.set(1, p.y);
  triple.set(2, p.z);
  return triple;
}

/// {positions, indices}: a surface's arrays.
inline emscripten::val arraysOf(const SurfaceMesh& mesh) {
  std::vector<double> positions;
  positions.reserve(3 * std::size_t{mesh.vertexCount()});
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    positions.insert(positions.end(), {p.x, p.y, p.z});
  }
  std::vector<Index> indices;
  indices.reserve(mesh.halfedgeCount());
  for (const Halfedge h : mesh.halfedges()) indices.push_back(mesh.from(h));
  emscripten::val result = emscripten::val::object();
  result.set("positions", copyOut<double>("Float64Array", positions));
  result.set("indices", copyOut<Index>("Uint32Array", indices));
  return result;
}

/// A surface's arrays and what follows from them: `Described` of wasm-modules.d.ts.
inline emscripten::val describe(const SurfaceMesh& mesh) {
  emscripten::val genus = emscripten::val::array();
  emscripten::val boundaries = emscripten::val::array();
  for (Index c = 0; c < mesh.componentCount(); ++c) {
    genus.set(c, mesh.genus(c));
    boundaries.set(c, mesh.boundaryCount(c));
  }
  emscripten::val result = arraysOf(mesh);
  std::vector<Index> boundary;
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.twin(h) == kNoIndex) boundary.insert(boundary.end(), {mesh.from(h), mesh.to(h)});
  }
  result.set("origin", tripleOf(drawingOrigin(mesh)));
  result.set("boundary", copyOut<Index>("Uint32Array", boundary));
  result.set("genus", genus);
  result.set("boundaries", boundaries);
  result.set("area", mesh.area());
  return result;
}

}  // namespace girth::bind
