#include "write/point_json.h"

#include <array>
#include <cstddef>

#include "text/number_text.h"

namespace girth::io {

std::string pointText(const Vec3& point, char separator) {
  return formatNumber(point.x) + separator + formatNumber(point.y) + separator +
         formatNumber(point.z);
}

std::string inputText(const LoadedMesh& loaded, Index vertex) {
  const Index input = loaded.inputOfVertex[vertex];
  return input == kNoIndex ? "null" : std::to_string(input);
}

std::string inputsJson(const LoadedMesh& loaded, const std::vector<Index>& vertices) {
  std::string text;
  for (const Index v : vertices) {
    if (loaded.inputOfVertex[v] == kNoIndex) continue;
    text += (text.empty() ? "" : ",") + std::to_string(loaded.inputOfVertex[v]);
  }
  return "[" + text + "]";
}

std::string pointJson(const LoadedMesh& loaded, const SurfacePoint& point) {
  const SurfaceMesh& mesh = loaded.mesh;
  std::array<Index, 3> vertices{};
  std::size_t count = 0;
  switch (point.kind) {
    case SurfacePoint::Kind::Vertex:
      vertices[0] = point.element;
      count = 1;
      break;
    case SurfacePoint::Kind::Edge:
      vertices = {mesh.from(point.element), mesh.to(point.element), 0};
      count = 2;
      break;
    case SurfacePoint::Kind::Face:
      vertices = mesh.faceVertices(point.element);
      count = 3;
      break;
  }
  std::string numbers;
  std::string weights;
  for (std::size_t i = 0; i < count; ++i) {
    const char* separator = i == 0 ? "" : ",";
    numbers += separator + inputText(loaded, vertices[i]);
    weights += separator + formatNumber(point.weights[i]);
  }
  return "{\"position\":[" + pointText(positionOf(mesh, point), ',') + "],\"vertices\":[" +
         numbers + "],\"weights\":[" + weights + "]}";
}

}  // namespace girth::io
