#include "result_object.h"

#include "described.h"
#include "surface_point.h"

namespace girth::bind {

void ResultObject::operator()(const char* name, double number) { object_.set(name, number); }

void ResultObject::operator()(const char* name, bool isSo) { object_.set(name, isSo); }

void ResultObject::operator()(const char* name, Index number) { object_.set(name, number); }

void ResultObject::operator()(const char* name, std::string_view word) {
  object_.set(name, std::string(word));
}

void ResultObject::operator()(const char* name, const Vec3& point) {
  object_.set(name, tripleOf(point));
}

void ResultObject::operator()(const char* name, const SurfacePoint& point) {
  object_.set(name, surfacePointOf(point));
}

void ResultObject::operator()(const char* name, std::span<const SurfacePoint> points) {
  emscripten::val list = emscripten::val::array();
  for (const SurfacePoint& point : points) list.call<void>("push", surfacePointOf(point));
  object_.set(name, list);
}

void ResultObject::operator()(const char* name, Vertex vertex) {
  object_.set(name, vertex == Vertex::none ? -1 : static_cast<double>(vertex));
}

void ResultObject::operator()(const char* name, const std::vector<Vertex>& vertices) {
  object_.set(name, copyOut<Index>("Uint32Array", numbersOf(vertices)));
}

void ResultObject::operator()(const char* name, const std::vector<Face>& faces) {
  object_.set(name, copyOut<Index>("Uint32Array", numbersOf(faces)));
}

void ResultObject::operator()(const char* name, const VertexNumbers& numbers) {
  object_.set(name, copyOut<double>("Float64Array", numbers.numbers));
}

void ResultObject::operator()(const char* name, const Numbers& numbers) {
  emscripten::val list = emscripten::val::array();
  for (const Index place : numbers.places) list.call<void>("push", place);
  object_.set(name, list);
}

void ResultObject::operator()(const char* name, const Curve& curve) {
  (*this)(name, curve.points);
  (*this)(name, Line{curve.points});
}

void ResultObject::operator()(const char* name, const DrawnPoint& drawn) {
  const auto& [x, y, z] = positionOf(*surface_.mesh, drawn.point);
  const Vec3& origin = surface_.origin;
  (*this)(name, Vec3{x - origin.x, y - origin.y, z - origin.z});
}

void ResultObject::operator()(const char*, const Line& line) {
  std::vector<Vec3> drawn;
  drawn.reserve(line.points.size());
  for (const SurfacePoint& point : line.points) {
    drawn.push_back(positionOf(*surface_.mesh, point));
  }
  object_.set("polyline", drawnPoints(drawn, surface_.origin));
}

}  // namespace girth::bind
