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
  void read(pybind11::handle from, std::string& text) const { text = from.cast<std::string>(); }
  /// None: the one that the options have at first.
  void read(pybind11::handle from, SurfacePoint& point) const {
    if (!from.is_none()) point = pointOf(from.cast<Point>());
  }
  /// A word that Python has checked.
  template <class Word>
  requires std::is_enum_v<Word>
  void read(pybind11::handle from, Word& word) const {
    const auto text = from.cast<std::string>();
    for (int code = 0; !toString(static_cast<Word>(code)).empty(); ++code) {
      if (toString(static_cast<Word>(code)) == text) word = static_cast<Word>(code);
    }
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
