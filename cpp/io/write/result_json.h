// Results as JSON: what girth/describe lists, in the numbers of the file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "girth/describe/cut_surface.h"
#include "girth/describe/description.h"
#include "girth/io/read_mesh.h"
#include "text/json_text.h"
#include "write/point_json.h"

namespace girth::io {

/// A JSON object of members of results.
class ResultJson : public JsonObject {
 public:
  /// An object of results without points, vertices and faces; with a mesh, of what is of its
  /// surface.
  explicit ResultJson(const LoadedMesh* loaded = nullptr) : loaded_(loaded) {}
  /// The object about a model: with `file`, `unit`, and where it was measured on fewer triangles
  /// than the file has, `fewerFaces`, their number. The entries of its lists stand in lines of
  /// their own.
  ResultJson(std::string_view file, const LoadedMesh& loaded)
      : loaded_(&loaded), isOutermost_(true) {
    add("file", file).add("unit", loaded.unit);
    if (loaded.fewerFaces != 0) add("fewerFaces", loaded.fewerFaces);
  }

  /// Adds `persistence`, of the girth that something was found by, where it is not 0.
  ResultJson& addPersistence(double persistence) {
    if (persistence != 0) add("persistence", persistence);
    return *this;
  }

  /// Adds all members of a result.
  template <Described Struct>
  ResultJson& addMembers(const Struct& result) {
    visitMembers(result, [&](const char* name, const auto& value) { addValue(name, value); });
    return *this;
  }

  /// The object as the content of a file.
  std::string file() const { return text() + "\n"; }

  /// Adds one member.
  template <class Value>
  ResultJson& addValue(std::string_view name, const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) {
      add(name, value);
    } else if constexpr (std::is_convertible_v<Value, std::string_view>) {
      add(name, std::string_view(value));
    } else {
      addJson(name, textOf(value));
    }
    return *this;
  }

 private:
  template <class Word>
  requires std::is_enum_v<Word> std::string textOf(Word word)
  const { return jsonString(toString(word)); }
  std::string textOf(const Vec3& point) const { return "[" + pointText(point, ',') + "]"; }
  std::string textOf(const SurfacePoint& point) const { return pointJson(*loaded_, point); }
  std::string textOf(const std::vector<SurfacePoint>& points) const {
    return pointsJson(*loaded_, points);
  }
  std::string textOf(const Curve& curve) const { return pointsJson(*loaded_, curve.points); }
  std::string textOf(const Line& line) const { return positionsJson(*loaded_, line.points); }
  std::string textOf(Vertex vertex) const { return vertexJson(*loaded_, vertex); }
  std::string textOf(const std::vector<Vertex>& vertices) const {
    return inputsJson(*loaded_, vertices);
  }
  std::string textOf(const std::vector<Face>& faces) const { return facesJson(*loaded_, faces); }
  std::string textOf(const VertexNumbers& numbers) const { return numbersJson(*loaded_, numbers); }
  std::string textOf(const Numbers& numbers) const { return numbersJson(numbers.places); }
  template <class Value>
  std::string textOf(const Value* value) const {
    return value == nullptr ? "null" : textOf(*value);
  }
  template <Described Struct>
  std::string textOf(const Struct& result) const {
    return ResultJson(loaded_).addMembers(result).text();
  }
  template <Described Struct>
  std::string textOf(const std::vector<Struct>& list) const {
    return textOf(std::span<const Struct>(list));
  }
  template <Described Struct>
  std::string textOf(std::span<const Struct> list) const {
    JsonList entries(isOutermost_);
    for (const Struct& one : list) entries.add(textOf(one));
    return entries.text();
  }
  /// Short, and so in one line.
  std::string textOf(const std::vector<CurveSide>& sides) const {
    JsonList entries;
    for (const CurveSide& side : sides) entries.add(textOf(side));
    return entries.text();
  }

  const LoadedMesh* loaded_;
  bool isOutermost_{false};
};

}  // namespace girth::io
