#include "girth/io/write_loop.h"

#include <cstddef>

#include "text/json_text.h"
#include "text/number_text.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {

std::string loopJson(const LoadedMesh& loaded, const GirthLoop& loop, std::string_view file,
                     bool withPoints, double persistence) {
  const std::string vertex = loop.base.kind == SurfacePoint::Kind::AtVertex
                                 ? inputText(loaded, loop.base.vertex())
                                 : "null";
  std::string text =
      "{\"file\":" + jsonString(file) + ",\"vertex\":" + vertex +
      ",\"base\":" + pointJson(loaded, loop.base) + ",\"length\":" + formatNumber(loop.length) +
      ",\"kind\":" + jsonString(toString(loop.kind)) + ",\"angle\":" + formatNumber(loop.angle) +
      ",\"unit\":" + jsonString(loaded.unit) + persistenceJson(persistence) +
      ",\"midpoint\":" + pointJson(loaded, loop.midpoint);
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
  writer.endMesh(TINYGLTF_MODE_LINE_STRIP, "{\"length\":" + formatNumber(loop.length) +
                                               ",\"kind\":" + jsonString(toString(loop.kind)) +
                                               ",\"angle\":" + formatNumber(loop.angle) +
                                               ",\"unit\":" + jsonString(loaded.unit) + "}");
  return writer.file(loaded.unit);
}

}  // namespace girth::io
