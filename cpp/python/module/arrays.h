// Arrays between NumPy and the core: those that come out own the core's memory, nothing is copied.
#pragma once

#include <pybind11/numpy.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "girth/elements.h"
#include "girth/error.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth::python {

/// A C-contiguous array, as the Python files of the package hand them over.
template <class Value>
using Array = pybind11::array_t<Value, pybind11::array::c_style>;

/// The numbers of an array, valid as long as it.
template <class Value>
std::span<const Value> spanOf(const Array<Value>& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// An array of a shape that takes over a vector's memory.
template <class Value>
Array<Value> arrayOf(std::vector<Value> values, std::vector<pybind11::ssize_t> shape) {
  auto owner = std::make_unique<std::vector<Value>>(std::move(values));
  const pybind11::capsule capsule(
      owner.get(), [](void* memory) { delete static_cast<std::vector<Value>*>(memory); });
  const Value* const data = owner.release()->data();
  return Array<Value>(std::move(shape), data, capsule);
}

/// An array of one dimension that takes over a vector's memory.
template <class Value>
Array<Value> arrayOf(std::vector<Value> values) {
  const auto size = static_cast<pybind11::ssize_t>(values.size());
  return arrayOf(std::move(values), {size});
}

/// The numbers of elements; -1: none.
template <class Numbers>
Array<std::int64_t> numberArray(const Numbers& elements) {
  std::vector<std::int64_t> numbers;
  numbers.reserve(elements.size());
  for (const Index element : elements) {
    numbers.push_back(element == kNoIndex ? -1 : static_cast<std::int64_t>(element));
  }
  return arrayOf(std::move(numbers));
}

/// The number of an element; -1: none.
inline std::int64_t numberOf(Index element) {
  return element == kNoIndex ? -1 : static_cast<std::int64_t>(element);
}

/// A point in space, shape (3,).
inline Array<double> pointArray(const Vec3& point) {
  return arrayOf(std::vector<double>{point.x, point.y, point.z});
}

/// Where points of a surface are in space, shape (n, 3).
inline Array<double> placesOf(const SurfaceMesh& mesh, std::span<const SurfacePoint> points) {
  std::vector<double> places;
  places.reserve(3 * points.size());
  for (const SurfacePoint& point : points) {
    const Vec3 place = positionOf(mesh, point);
    places.insert(places.end(), {place.x, place.y, place.z});
  }
  return arrayOf(std::move(places), {static_cast<pybind11::ssize_t>(points.size()), 3});
}

/// The positions of all vertices, shape (n, 3).
inline Array<double> positionArray(const SurfaceMesh& mesh) {
  std::vector<double> positions;
  positions.reserve(3 * static_cast<std::size_t>(mesh.vertexCount()));
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    positions.insert(positions.end(), {p.x, p.y, p.z});
  }
  return arrayOf(std::move(positions), {static_cast<pybind11::ssize_t>(mesh.vertexCount()), 3});
}

/// The vertices of all faces, shape (m, 3).
inline Array<std::int64_t> triangleArray(const SurfaceMesh& mesh) {
  std::vector<std::int64_t> faces;
  faces.reserve(3 * static_cast<std::size_t>(mesh.faceCount()));
  for (const Face face : mesh.faces()) {
    for (const Vertex v : mesh.faceVertices(face)) faces.push_back(v);
  }
  return arrayOf(std::move(faces), {static_cast<pybind11::ssize_t>(mesh.faceCount()), 3});
}

/// The ends of the edges on the boundary, shape (b, 2): the lesser vertex first, in rising order.
inline Array<std::int64_t> boundaryArray(const SurfaceMesh& mesh) {
  std::vector<std::array<std::int64_t, 2>> edges;
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.twin(h) != Halfedge::none) continue;
    const std::int64_t from = mesh.from(h), to = mesh.to(h);
    edges.push_back({std::min(from, to), std::max(from, to)});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::int64_t> ends;
  ends.reserve(2 * edges.size());
  for (const auto& edge : edges) ends.insert(ends.end(), edge.begin(), edge.end());
  return arrayOf(std::move(ends), {static_cast<pybind11::ssize_t>(edges.size()), 2});
}

}  // namespace girth::python
