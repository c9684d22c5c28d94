// Results as JSON: what girth/describe lists, in the numbers of the file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "girth/describe/cut_surface.h"
#include "girth/describe/description.h"
#include "girth/export.h"
#include "girth/io/json_text.h"
#include "girth/io/read_mesh.h"

namespace girth::io {

/// A JSON object of members of results.
class GIRTH_EXPORT ResultJson : public JsonObject {
 public:
  /// An object of results without points, vertices and faces; with a mesh, of what is of its
  /// surface.
  explicit ResultJson(const LoadedMesh* loaded = nullptr) : loaded_(loaded) {}
  /// The object about a model: what commands write. With `file`, `unit`, and where it was measured
  /// on fewer triangles than the file has, `fewerFaces`, their number. The entries of its lists
  /// stand in lines of their own.
  ResultJson(std::string_view file, const LoadedMesh& loaded);

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
    if constexpr (std::is_pointer_v<Value>) {
      if (value == nullptr) {
        addJson(name, "null");
      } else {
        addValue(name, *value);
      }
    } else if constexpr (std::is_arithmetic_v<Value>) {
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
  std::string textOf(const Vec3& point) const;
  std::string textOf(const SurfacePoint& point) const;
  std::string textOf(const std::vector<SurfacePoint>& points) const;
  std::string textOf(const Curve& curve) const;
  std::string textOf(const Line& line) const;
  std::string textOf(const DrawnPoint& drawn) const { return textOf(drawn.point); }
  std::string textOf(Vertex vertex) const;
  std::string textOf(const std::vector<Vertex>& vertices) const;
  std::string textOf(const std::vector<Face>& faces) const;
  std::string textOf(const VertexNumbers& numbers) const;
  std::string textOf(const Numbers& numbers) const;
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

/// A result as the command writes it: one JSON object with `file`, `unit` and its members.
template <Described Struct>
std::string resultJson(const LoadedMesh& loaded, const Struct& result, std::string_view file) {
  return ResultJson(file, loaded).addMembers(result).file();
}

}  // namespace girth::io
