// Results as JavaScript receives them: what girth/describe lists.
#pragma once

#include <emscripten/val.h>

#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "boundary.h"
#include "girth/describe/description.h"

namespace girth::bind {

/// A surface, and what drawn points of it are relative to.
struct DrawnSurface {
  const SurfaceMesh* mesh;
  Vec3 origin;
};

/// An object of members of results.
class ResultObject {
 public:
  /// An object without members. `surface`: that of the results; none where they have no points.
  explicit ResultObject(const DrawnSurface& surface = {}) : surface_(surface) {}

  /// The object with the members so far.
  const emscripten::val& object() const { return object_; }

  /// Adds all members of a result.
  template <Described Struct>
  ResultObject& addMembers(const Struct& result) {
    visitMembers(result, *this);
    return *this;
  }

  /// Adds a member: what is a value of JavaScript already, and what becomes one.
  void operator()(const char* name, const emscripten::val& value) { object_.set(name, value); }
  void operator()(const char* name, double number);
  void operator()(const char* name, bool isSo);
  void operator()(const char* name, Index number);
  void operator()(const char* name, std::string_view word);
  void operator()(const char* name, const Vec3& point);
  void operator()(const char* name, const SurfacePoint& point);
  void operator()(const char* name, std::span<const SurfacePoint> points);
  /// -1 where it is none.
  void operator()(const char* name, Vertex vertex);
  void operator()(const char* name, const std::vector<Vertex>& vertices);
  void operator()(const char* name, const std::vector<Face>& faces);
  void operator()(const char* name, const VertexNumbers& numbers);
  void operator()(const char* name, const Numbers& numbers);
  /// With its `polyline`.
  void operator()(const char* name, const Curve& curve);
  /// Its `polyline` alone.
  void operator()(const char* name, const Line& line);
  /// x, y and z, relative to the origin.
  void operator()(const char* name, const DrawnPoint& drawn);
  template <class Word>
  requires std::is_enum_v<Word>
  void operator()(const char* name, Word word) { (*this)(name, toString(word)); }
  /// Nothing where it is null.
  template <class Value>
  void operator()(const char* name, const Value* value) {
    if (value != nullptr) (*this)(name, *value);
  }
  template <Described Struct>
  void operator()(const char* name, const Struct& result) {
    (*this)(name, ResultObject(surface_).addMembers(result).object());
  }
  template <Described Struct>
  void operator()(const char* name, const std::vector<Struct>& list) {
    emscripten::val entries = emscripten::val::array();
    for (const Struct& one : list) {
      entries.call<void>("push", ResultObject(surface_).addMembers(one).object());
    }
    (*this)(name, entries);
  }

 private:
  DrawnSurface surface_;
  emscripten::val object_ = emscripten::val::object();
};

/// A result as JavaScript receives it; or an error.
template <Described Struct>
emscripten::val objectOf(const DrawnSurface& surface, const Result<Struct>& found) {
  return found ? ResultObject(surface).addMembers(found.value()).object() : toJs(found.error());
}

}  // namespace girth::bind
