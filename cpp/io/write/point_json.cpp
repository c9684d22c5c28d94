#include "write/point_json.h"

#include <array>
#include <cstddef>

#include "text/json_text.h"
#include "text/number_text.h"

namespace girth::io {

std::string modelJson(std::string_view file, const LoadedMesh& loaded) {
  return "{\"file\":" + jsonString(file) + ",\"unit\":" + jsonString(loaded.unit) +
         (loaded.fewerFaces == 0 ? "" : ",\"fewerFaces\":" + std::to_string(loaded.fewerFaces));
}

std::string pointText(const Vec3& point, char separator) {
  return formatNumber(point.x) + separator + formatNumber(point.y) + separator +
         formatNumber(point.z);
}

std::string inputText(const LoadedMesh& loaded, Vertex vertex) {
  const Index input = loaded.inputOfVertex[vertex];
  return input == kNoIndex ? "null" : std::to_string(input);
}

std::string inputsJson(const LoadedMesh& loaded, const std::vector<Vertex>& vertices) {
  std::string text;
  for (const Vertex v : vertices) {
    if (loaded.inputOfVertex[v] == kNoIndex) continue;
    text += (text.empty() ? "" : ",") + std::to_string(loaded.inputOfVertex[v]);
  }
  return "[" + text + "]";
}

std::string persistenceJson(double persistence) {
  return persistence == 0 ? "" : ",\"persistence\":" + formatNumber(persistence);
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

std::string pointsJson(const LoadedMesh& loaded, const std::vector<SurfacePoint>& points) {
  std::string text = "[";
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + pointJson(loaded, points[i]);
  }
  return text + "]";
}

std::string sidesJson(const std::vector<CurveSide>& sides) {
  std::string text;
  for (const CurveSide& side : sides) {
    text += (text.empty() ? "" : ",") + ("{\"area\":" + formatNumber(side.area)) +
            ",\"volume\":" + numberJson(side.volume) + "}";
  }
  return "[" + text + "]";
}

void appendClosedLine(const LoadedMesh& loaded, const std::vector<SurfacePoint>& points,
                      std::size_t& count, std::string& obj) {
  std::string line = "l";
  const std::size_t first = count + 1;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    obj += "v " + pointText(positionOf(loaded.mesh, points[i]), ' ') + "\n";
    line += " " + std::to_string(++count);
  }
  obj += line + " " + std::to_string(first) + "\n";
}

}  // namespace girth::io
