#include "result_again.h"

#include <algorithm>
#include <string>
#include <utility>

#include "boundary.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {

namespace {

/// No enumeration of results has more.
constexpr int kMostWords = 16;

}  // namespace

void ResultAgain::read(const val& from, double& number) { number = from.as<double>(); }

void ResultAgain::read(const val& from, bool& isSo) { isSo = from.as<bool>(); }

void ResultAgain::read(const val& from, Index& number) { number = indexOf(from.as<double>()); }

void ResultAgain::read(const val& from, std::size_t& number) {
  number = indexOf(from.as<double>());
}

void ResultAgain::read(const val& from, Vertex& vertex) {
  const auto number = from.as<double>();
  vertex = Vertex(indexOf(number));
  if (number != -1) check(vertex);
}

void ResultAgain::read(const val& from, Vec3& point) {
  if (from.isNull() || lengthOf(from) != 3)
    return refuse(std::string(member_) + " has three numbers");
  point = {from[0].as<double>(), from[1].as<double>(), from[2].as<double>()};
}

void ResultAgain::read(const val& from, std::string& text) {
  if (!from.isString()) return refuse(std::string(member_) + " is no text");
  text = from.as<std::string>();
}

void ResultAgain::read(const val& from, SurfacePoint& point) {
  if (!from.isNumber() && (!from.as<bool>() || !from["weights"].as<bool>())) {
    return refuse(std::string(member_) + " is no point of a surface");
  }
  point = pointAgain(from);
  check(point);
}

void ResultAgain::read(const val& from, std::vector<double>& numbers) {
  numbers = copyIn<double>(from);
}

void ResultAgain::read(const val& from, std::vector<Vertex>& vertices) {
  for (const Index number : copyIn<Index>(from)) check(vertices.emplace_back(number));
}

void ResultAgain::read(const val& from, std::vector<Face>& faces) {
  for (const Index number : copyIn<Index>(from)) check(faces.emplace_back(number));
}

void ResultAgain::readLine(const val& from, std::vector<SurfacePoint>& points) {
  const std::size_t count = lengthOf(from["polyline"]) / 3;
  if (count > linePoints_.size() - lineStart_) {
    isOfMesh_ = false;
    return;
  }
  for (const std::size_t end = lineStart_ + count; lineStart_ < end; ++lineStart_) {
    check(points.emplace_back(linePoints_[lineStart_]));
  }
}

std::size_t ResultAgain::lengthOf(const val& list) { return list["length"].as<unsigned>(); }

val ResultAgain::entryOf(const val& list, std::size_t place) {
  return list[static_cast<unsigned>(place)];
}

val ResultAgain::memberOf(const val& object, const char* name) { return object[name]; }

bool ResultAgain::isThere(const val& value) { return !value.isUndefined(); }

int ResultAgain::codeOf(const val& word, std::string_view (*wordOf)(int)) {
  const std::string text = word.isString() ? word.as<std::string>() : "";
  for (int code = 0; code < kMostWords && !text.empty(); ++code) {
    if (wordOf(code) == text) return code;
  }
  refuse("'" + text + "' is no " + member_);
  return 0;
}

void ResultAgain::refuseOthers(const val& object, std::initializer_list<std::string_view> names) {
  const val keys = val::global("Object").call<val>("keys", object);
  for (std::size_t i = 0; i < lengthOf(keys); ++i) {
    const auto key = entryOf(keys, i).as<std::string>();
    if (std::find(names.begin(), names.end(), key) != names.end()) continue;
    std::string all;
    for (const std::string_view name : names) all.append(all.empty() ? "" : ", ").append(name);
    refuse("there is no option " + key + "; there are " + all);
  }
}

void ResultAgain::refuse(std::string problem) {
  if (problem_.empty()) problem_ = std::move(problem);
}

void ResultAgain::check(Vertex vertex) {
  isOfMesh_ = isOfMesh_ && Index{vertex} < mesh_.vertexCount();
}

void ResultAgain::check(Face face) { isOfMesh_ = isOfMesh_ && Index{face} < mesh_.faceCount(); }

void ResultAgain::check(const SurfacePoint& point) {
  if (point.vertex() != Vertex::none) {
    check(point.vertex());
  } else {
    check(beside(point).face());
  }
}

}  // namespace girth::bind
