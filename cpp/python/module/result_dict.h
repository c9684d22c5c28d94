// Results as Python receives them: what girth/describe lists, with names in snake_case.
#pragma once

#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "arrays.h"
#include "curves.h"
#include "girth/describe/cut_surface.h"
#include "girth/describe/description.h"
#include "girth/girth_profile.h"

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

/// The members of a result. Vertices and faces have the surface's numbers; points are positions.
template <Described Struct>
pybind11::dict dictOf(const SurfaceMesh& mesh, const Struct& result);

/// A list of results.
template <Described Struct>
pybind11::list listOf(const SurfaceMesh& mesh, const std::vector<Struct>& results) {
  pybind11::list list;
  for (const Struct& result : results) list.append(dictOf(mesh, result));
  return list;
}

/// Fills a dictionary, member by member.
class ResultDict {
 public:
  ResultDict(const SurfaceMesh& mesh, pybind11::dict members)
      : mesh_(mesh), members_(std::move(members)) {}

  void operator()(const char* name, const Curve& curve) {
    (*this)(name, curve.points);
    members_["curve"] = curveOf(curve.points);
  }
  /// A row of numbers for each station, and where their least girths are, as `places`.
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
    members_["places"] = curveOf(places);
  }
  template <class Value>
  void operator()(const char* name, const Value& value) {
    members_[snakeCase(name)] = valueOf(value);
  }

 private:
  template <class Value>
  requires std::is_arithmetic_v<Value> Value valueOf(Value value)
  const { return value; }
  template <class Word>
  requires std::is_enum_v<Word> std::string valueOf(Word word)
  const { return std::string(toString(word)); }
  Array<double> valueOf(const Vec3& point) const { return pointArray(point); }
  Array<double> valueOf(const SurfacePoint& point) const {
    return pointArray(positionOf(mesh_, point));
  }
  Array<double> valueOf(std::span<const SurfacePoint> points) const {
    return placesOf(mesh_, points);
  }
  Array<double> valueOf(const Line& line) const { return placesOf(mesh_, line.points); }
  std::int64_t valueOf(Vertex vertex) const { return numberOf(vertex); }
  Array<std::int64_t> valueOf(const std::vector<Vertex>& vertices) const {
    return numberArray(vertices);
  }
  Array<double> valueOf(const VertexNumbers& numbers) const {
    return arrayOf(std::vector<double>(numbers.numbers.begin(), numbers.numbers.end()));
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
    return dictOf(mesh_, result);
  }
  template <Described Struct>
  pybind11::list valueOf(const std::vector<Struct>& results) const {
    return listOf(mesh_, results);
  }

  const SurfaceMesh& mesh_;
  pybind11::dict members_;
};

template <Described Struct>
pybind11::dict dictOf(const SurfaceMesh& mesh, const Struct& result) {
  pybind11::dict members;
  visitMembers(result, ResultDict(mesh, members));
  return members;
}

}  // namespace girth::python
