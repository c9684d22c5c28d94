#include "girth/io/write_loop.h"

#include <array>
#include <cstddef>

#include "girth/io/json_text.h"
#include "girth/io/number_text.h"
#include "glb_writer.h"

namespace girth::io {
namespace {

std::string pointText(const Vec3& point, char separator) {
  return formatNumber(point.x) + separator + formatNumber(point.y) + separator +
         formatNumber(point.z);
}

/// The vertex of the file that a vertex of the surface comes from; null where it was made here.
std::string inputText(const LoadedMesh& loaded, Index vertex) {
  const Index input = loaded.inputOfVertex[vertex];
  return input == kNoIndex ? "null" : std::to_string(input);
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

}  // namespace

std::string loopJson(const LoadedMesh& loaded, const GirthLoop& loop, std::string_view file,
                     bool withPoints) {
  const std::string vertex =
      loop.base.kind == SurfacePoint::Kind::Vertex ? inputText(loaded, loop.base.element) : "null";
  std::string text =
      "{\"file\":" + jsonString(file) + ",\"vertex\":" + vertex +
      ",\"base\":" + pointJson(loaded, loop.base) + ",\"length\":" + formatNumber(loop.length) +
      ",\"kind\":" + jsonString(toString(loop.kind)) + ",\"angle\":" + formatNumber(loop.angle) +
      ",\"unit\":" + jsonString(loaded.unit) + ",\"midpoint\":" + pointJson(loaded, loop.midpoint);
  if (withPoints) {
    text += ",\"points\":[";
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      text += (i == 0 ? "\n" : ",\n") + pointJson(loaded, loop.points[i]);
    }
    text += "]";
  }
  return text + "}\n";
}

std::string loopObj(const LoadedMesh& loaded, const GirthLoop& loop) {
  const std::vector<Vec3> points = polyline(loaded.mesh, loop);
  std::string text;
  std::string line = "l";
  // The last point is the first one again.
  const std::size_t distinct = points.empty() ? 0 : points.size() - 1;
  for (std::size_t i = 0; i < distinct; ++i) {
    text += "v " + pointText(points[i], ' ') + "\n";
    line += " " + std::to_string(i + 1);
  }
  return text + line + " 1\n";
}

std::string loopCsv(const LoadedMesh& loaded, const GirthLoop& loop) {
  std::string text = "x,y,z\n";
  for (const Vec3& point : polyline(loaded.mesh, loop)) text += pointText(point, ',') + "\n";
  return text;
}

Result<std::string> loopGlb(const LoadedMesh& loaded, const GirthLoop& loop) {
  const std::vector<Vec3> points = polyline(loaded.mesh, loop);
  if (points.empty()) return makeError(ErrorCode::EmptyMesh, -1, "the loop has no points");
  GlbWriter writer;
  writer.addPositions(points);
  constexpr int kLineStrip = 3;
  return writer.file(
      kLineStrip, loaded.unit,
      "{\"length\":" + formatNumber(loop.length) + ",\"kind\":" + jsonString(toString(loop.kind)) +
          ",\"angle\":" + formatNumber(loop.angle) + ",\"unit\":" + jsonString(loaded.unit) + "}");
}

}  // namespace girth::io
