// Results that JavaScript hands back: what `ResultObject` made of them, as structs again, to the
// bit.
#pragma once

#include <emscripten/val.h>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "girth/describe/description.h"
#include "girth/surface_mesh.h"

namespace girth::bind {

class ResultAgain {
 public:
  /// `linePoints`: the points of lines, whose objects have drawn positions alone, in the order of
  /// the results.
  explicit ResultAgain(const SurfaceMesh& mesh, std::vector<SurfacePoint> linePoints = {})
      : mesh_(mesh), linePoints_(std::move(linePoints)) {}

  /// Options that people write: a name that is none of their members is a problem.
  static ResultAgain ofOptions(const SurfaceMesh& mesh) {
    ResultAgain again(mesh);
    again.isOfOptions_ = true;
    return again;
  }

  /// Whether all vertices, faces and points so far are there on the mesh.
  bool isOfMesh() const { return isOfMesh_; }
  /// The first member that lacks, is none, or has no value of its kind, in words; empty: all is
  /// well.
  const std::string& problem() const { return problem_; }

  void read(const emscripten::val& from, double& number);
  void read(const emscripten::val& from, bool& isSo);
  void read(const emscripten::val& from, Index& number);
  void read(const emscripten::val& from, std::size_t& number);
  void read(const emscripten::val& from, Vertex& vertex);
  void read(const emscripten::val& from, std::string& text);
  void read(const emscripten::val& from, Vec3& point);
  void read(const emscripten::val& from, SurfacePoint& point);
  void read(const emscripten::val& from, std::vector<double>& numbers);
  void read(const emscripten::val& from, std::vector<Vertex>& vertices);
  void read(const emscripten::val& from, std::vector<Face>& faces);
  template <class Value>
  void read(const emscripten::val& from, std::vector<Value>& list) {
    list.resize(lengthOf(from));
    for (std::size_t i = 0; i < list.size(); ++i) read(entryOf(from, i), list[i]);
  }
  template <class Word>
  requires std::is_enum_v<Word>
  void read(const emscripten::val& from, Word& word) {
    word =
        static_cast<Word>(codeOf(from, [](int code) { return toString(static_cast<Word>(code)); }));
  }
  template <Described Struct>
  void read(const emscripten::val& from, Struct& result) {
    std::apply(
        [&](const auto&... one) {
          (readMember(from, result, one), ...);
          if (isOfOptions_) refuseOthers(from, {nameOf(one)...});
        },
        describe(Members<Struct>()));
  }

 private:
  static const char* nameOf(const Unwritten&) { return ""; }
  template <class Get, class Which>
  static const char* nameOf(const Member<Get, Which>& member) {
    return member.name;
  }

  template <class Struct>
  void readMember(const emscripten::val&, Struct&, const Unwritten&) {}

  template <class Struct, class Get, class Which>
  void readMember(const emscripten::val& from, Struct& result, const Member<Get, Which>& member) {
    if constexpr (!std::is_same_v<Which, std::nullptr_t>) {
      using Shown = std::decay_t<std::invoke_result_t<Get, const Struct&>>;
      if constexpr (std::is_same_v<Shown, Line>) {
        readLine(from, result.*member.which);
      } else if (const emscripten::val value = memberOf(from, member.name); isThere(value)) {
        member_ = member.name;
        read(value, result.*member.which);
      } else if (member.isNeeded) {
        refuse(std::string("there is no ") + member.name);
      }
    }
  }

  /// The next points of lines, as many as the drawn line has.
  void readLine(const emscripten::val& from, std::vector<SurfacePoint>& points);

  // Out of line: they are called for each member of each struct.
  static std::size_t lengthOf(const emscripten::val& list);
  static emscripten::val entryOf(const emscripten::val& list, std::size_t place);
  static emscripten::val memberOf(const emscripten::val& object, const char* name);
  static bool isThere(const emscripten::val& value);
  /// The enumerator of a word; 0 and a problem for none.
  int codeOf(const emscripten::val& word, std::string_view (*wordOf)(int));
  /// A problem where an object has other members than these.
  void refuseOthers(const emscripten::val& object, std::initializer_list<std::string_view> names);
  /// Notes a problem, if it is the first.
  void refuse(std::string problem);

  void check(Vertex vertex);
  void check(Face face);
  void check(const SurfacePoint& point);

  const SurfaceMesh& mesh_;
  std::vector<SurfacePoint> linePoints_;
  std::size_t lineStart_{0};
  bool isOfMesh_{true};
  bool isOfOptions_{false};
  const char* member_{""};  ///< the member that is being read
  std::string problem_;
};

}  // namespace girth::bind
