// Results as Python receives them: what girth/describe lists, with names in snake_case.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "arrays.h"
#include "curves.h"
#include "girth/describe/cut_surface.h"
#include "girth/describe/description.h"
#include "girth/girth_profile.h"
#include "girth/io/read_mesh.h"

namespace girth::python {

/// measuresGirth: measures_girth.
inline pybind11::str snakeCase(const char* name) {
  std::string text;
  for (; *name != '\0'; ++name) {
    const bool isCapital = *name >= 'A' && *name <= 'Z';
    if (isCapital) text += '_';
    text += static_cast<char>(isCapital ? *name - 'A' + 'a' : *name);
  }
  return text;
}

/// The row of the user's vertices that a vertex comes from; -1 where it was made by the
/// preparation.
inline std::int64_t rowOf(const io::LoadedMesh& loaded, Vertex vertex) {
  return vertex == Vertex::none ? -1 : numberOf(loaded.inputOfVertex[vertex]);
}

/// The members of a result. Vertices are rows of the user's vertices; points are positions.
template <Described Struct>
pybind11::dict dictOf(const io::LoadedMesh& loaded, const Struct& result);

/// A list of results.
template <Described Struct>
pybind11::list listOf(const io::LoadedMesh& loaded, const std::vector<Struct>& results) {
  pybind11::list list;
  for (const Struct& result : results) list.append(dictOf(loaded, result));
  return list;
}

/// Fills a dictionary, member by member.
class ResultDict {
 public:
  ResultDict(const io::LoadedMesh& loaded, pybind11::dict members)
      : loaded_(loaded), members_(std::move(members)) {}

  /// With the points as `cut` takes them.
  void operator()(const char* name, const Curve& curve) {
    (*this)(name, curve.points);
    members_["_curve"] = curveOf(curve.points);
  }
  /// A row of numbers for each station, and where their least girths are, as `axis` takes it.
  void operator()(const char* name, const GirthProfile& profile) {
    std::vector<double> numbers;
    SurfaceCurve places;
    for (const GirthStation& station : profile) {
      numbers.insert(numbers.end(),
                     {station.distance, station.ring, station.median, station.least});
      places.push_back(station.place);
    }
    members_[name] =
        arrayOf(std::move(numbers), {static_cast<pybind11::ssize_t>(profile.size()), 4});
    members_["_places"] = curveOf(places);
  }
  template <class Value>
  void operator()(const char* name, const Value& value) {
    if constexpr (!std::is_pointer_v<Value>) {
      members_[snakeCase(name)] = valueOf(value);
    } else if (value != nullptr) {
      (*this)(name, *value);
    } else {
      // A result without such a member.
      members_[snakeCase(name)] = pybind11::none();
    }
  }

 private:
  std::int64_t valueOf(Index number) const { return numberOf(number); }
  template <class Value>
  requires std::is_arithmetic_v<Value> Value valueOf(Value value)
  const { return value; }
  template <class Word>
  requires std::is_enum_v<Word> std::string valueOf(Word word)
  const { return std::string(toString(word)); }
  std::string valueOf(std::string_view word) const { return std::string(word); }
  Array<double> valueOf(const Vec3& point) const { return pointArray(point); }
  Array<double> valueOf(const SurfacePoint& point) const {
    return pointArray(positionOf(loaded_.mesh, point));
  }
  Array<double> valueOf(const DrawnPoint& drawn) const { return valueOf(drawn.point); }
  Array<double> valueOf(std::span<const SurfacePoint> points) const {
    return placesOf(loaded_.mesh, points);
  }
  Array<double> valueOf(const Line& line) const { return placesOf(loaded_.mesh, line.points); }
  std::int64_t valueOf(Vertex vertex) const { return rowOf(loaded_, vertex); }
  Array<std::int64_t> valueOf(const std::vector<Vertex>& vertices) const {
    std::vector<std::int64_t> rows;
    forEachRow(vertices, [&](std::size_t row, Vertex) { rows.push_back(std::int64_t(row)); });
    return arrayOf(std::move(rows));
  }
  /// Rows of the user's faces; those that the preparation made have none.
  Array<std::int64_t> valueOf(const std::vector<Face>& faces) const {
    std::vector<std::int64_t> rows;
    for (const Face face : faces) {
      const Index row = loaded_.inputOfFace[face];
      if (row != kNoIndex) rows.push_back(row);
    }
    return arrayOf(std::move(rows));
  }
  Array<double> valueOf(const VertexNumbers& numbers) const {
    std::vector<double> ofVertex(loaded_.mesh.vertexCount()), ofRow;
    for (std::size_t i = 0; i < numbers.vertices.size(); ++i) {
      ofVertex[numbers.vertices[i]] = numbers.numbers[i];
    }
    forEachRow(numbers.vertices, [&](std::size_t, Vertex v) { ofRow.push_back(ofVertex[v]); });
    return arrayOf(std::move(ofRow));
  }
  pybind11::list valueOf(const Numbers& numbers) const {
    pybind11::list list;
    for (const Index place : numbers.places) list.append(place);
    return list;
  }
  /// A row of area and volume for each.
  Array<double> valueOf(const std::vector<CurveSide>& sides) const {
    std::vector<double> numbers;
    for (const CurveSide& side : sides) numbers.insert(numbers.end(), {side.area, side.volume});
    return arrayOf(std::move(numbers), {static_cast<pybind11::ssize_t>(sides.size()), 2});
  }
  template <Described Struct>
  pybind11::dict valueOf(const Struct& result) const {
    return dictOf(loaded_, result);
  }
  template <Described Struct>
  pybind11::list valueOf(const std::vector<Struct>& results) const {
    return listOf(loaded_, results);
  }

  /// Calls `take(row, vertex)` for all rows of the user's vertices that are one of these, in order.
  template <class Take>
  void forEachRow(std::span<const Vertex> vertices, Take take) const {
    std::vector<bool> isChosen(loaded_.mesh.vertexCount());
    for (const Vertex v : vertices) isChosen[v] = true;
    for (std::size_t row = 0; row < loaded_.vertexOfInput.size(); ++row) {
      const Vertex v = loaded_.vertexOfInput[row];
      if (v != Vertex::none && isChosen[v]) take(row, v);
    }
  }

  const io::LoadedMesh& loaded_;
  pybind11::dict members_;
};

template <Described Struct>
pybind11::dict dictOf(const io::LoadedMesh& loaded, const Struct& result) {
  pybind11::dict members;
  visitMembers(result, ResultDict(loaded, members));
  return members;
}

}  // namespace girth::python
