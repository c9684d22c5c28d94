// Options as Python passes them: what girth/describe lists, as structs.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "girth/describe/description.h"
#include "points.h"

namespace girth::python {

/// Takes values of a tree of tuples and lists: a struct has its members in their order.
class OptionsFrom {
 public:
  void read(pybind11::handle from, double& number) const { number = from.cast<double>(); }
  void read(pybind11::handle from, bool& isSo) const { isSo = from.cast<bool>(); }
  /// No number of an element where it is none.
  void read(pybind11::handle from, Index& number) const {
    const auto whole = from.cast<std::int64_t>();
    number = whole >= 0 && whole < std::int64_t{kNoIndex} ? static_cast<Index>(whole) : kNoIndex;
  }
  void read(pybind11::handle from, SurfacePoint& point) const {
    point = pointOf(from.cast<Point>());
  }
  void read(pybind11::handle from, Vec3& place) const {
    const auto numbers = from.cast<std::vector<double>>();
    place = {numbers.at(0), numbers.at(1), numbers.at(2)};
  }
  template <class Value>
  void read(pybind11::handle from, std::vector<Value>& list) const {
    for (const pybind11::handle one : from) read(one, list.emplace_back());
  }
  template <Described Struct>
  void read(pybind11::handle from, Struct& options) const {
    std::size_t place = 0;
    const auto readOne = [&](const auto& member) {
      read(from[pybind11::int_(place++)], options.*member.which);
    };
    std::apply([&](const auto&... one) { (readOne(one), ...); }, describe(Members<Struct>()));
  }
};

}  // namespace girth::python
