#include "write/point_json.h"

#include <array>
#include <cstddef>

#include "girth/io/json_text.h"
#include "text/number_text.h"

namespace girth::io {
namespace {

/// Elements of the surface as a JSON array of the file's; those made here are left out.
template <class Element>
std::string inputs(const std::vector<Index>& inputOf, const std::vector<Element>& elements) {
  JsonList list;
  for (const Element element : elements) {
    if (inputOf[element] != kNoIndex) list.add(std::to_string(inputOf[element]));
  }
  return list.text();
}

}  // namespace

std::string pointText(const Vec3& point, char separator) {
  return formatNumber(point.x) + separator + formatNumber(point.y) + separator +
         formatNumber(point.z);
}

std::string inputText(const LoadedMesh& loaded, Vertex vertex) {
  const Index input = loaded.inputOfVertex[vertex];
  return input == kNoIndex ? "null" : std::to_string(input);
}

std::string inputsJson(const LoadedMesh& loaded, const std::vector<Vertex>& vertices) {
  return inputs(loaded.inputOfVertex, vertices);
}

std::string facesJson(const LoadedMesh& loaded, const std::vector<Face>& faces) {
  return inputs(loaded.inputOfFace, faces);
}

std::string numbersJson(const LoadedMesh& loaded, const VertexNumbers& numbers) {
  JsonList list;
  for (std::size_t i = 0; i < numbers.vertices.size(); ++i) {
    if (loaded.inputOfVertex[numbers.vertices[i]] == kNoIndex) continue;
    list.add(numberJson(numbers.numbers[i]));
  }
  return list.text();
}

std::string numbersJson(std::span<const Index> places) {
  JsonList list;
  for (const Index place : places) list.add(std::to_string(place));
  return list.text();
}

std::string pointJson(const LoadedMesh& loaded, const SurfacePoint& point) {
  const SurfaceMesh& mesh = loaded.mesh;
  std::array<Vertex, 3> vertices{};
  std::size_t count = 0;
  switch (point.kind) {
    case SurfacePoint::Kind::AtVertex:
      vertices[0] = point.vertex();
      count = 1;
      break;
    case SurfacePoint::Kind::OnEdge:
      vertices = {mesh.from(point.halfedge()), mesh.to(point.halfedge())};
      count = 2;
      break;
    case SurfacePoint::Kind::InFace:
      vertices = mesh.faceVertices(point.face());
      count = 3;
      break;
  }
  JsonList numbers, weights;
  for (std::size_t i = 0; i < count; ++i) {
    numbers.add(inputText(loaded, vertices[i]));
    weights.add(formatNumber(point.weights[i]));
  }
  return JsonObject()
      .addJson("position", "[" + pointText(positionOf(mesh, point), ',') + "]")
      .addJson("vertices", numbers.text())
      .addJson("weights", weights.text())
      .text();
}

std::string vertexJson(const LoadedMesh& loaded, Vertex vertex) {
  return vertex == Vertex::none ? "null" : pointJson(loaded, SurfacePoint::atVertex(vertex));
}

std::string positionsJson(const LoadedMesh& loaded, std::span<const SurfacePoint> points) {
  JsonList list;
  for (const SurfacePoint& point : points) {
    list.add("[" + pointText(positionOf(loaded.mesh, point), ',') + "]");
  }
  return list.text();
}

std::string pointsJson(const LoadedMesh& loaded, std::span<const SurfacePoint> points) {
  JsonList list(true);
  for (const SurfacePoint& point : points) list.add(pointJson(loaded, point));
  return list.text();
}

void appendLine(const LoadedMesh& loaded, const std::vector<SurfacePoint>& points, bool isClosed,
                std::size_t& count, std::string& obj) {
  std::string line = "l";
  const std::size_t first = count + 1;
  for (std::size_t i = 0; i + (isClosed ? 1 : 0) < points.size(); ++i) {
    obj += "v " + pointText(positionOf(loaded.mesh, points[i]), ' ') + "\n";
    line += " " + std::to_string(++count);
  }
  if (isClosed) line += " " + std::to_string(first);
  obj += line + "\n";
}

}  // namespace girth::io
