#include "girth/io/write_loop.h"

#include <cstddef>
#include <type_traits>

#include "girth/describe/girth_solver.h"
#include "girth/io/result_json.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {

std::string loopJson(const LoadedMesh& loaded, const GirthLoop& loop, std::string_view file,
                     bool withPoints, double persistence) {
  ResultJson json(&loaded);
  json.addValue("file", file)
      .addValue("vertex", loop.base.vertex() == Vertex::none
                              ? kNoIndex
                              : loaded.inputOfVertex[loop.base.vertex()])
      .addValue("unit", loaded.unit)
      .addPersistence(persistence);
  visitMembers(loop, [&]<class Value>(const char* name, const Value& value) {
    if (!std::is_same_v<Value, Curve> || withPoints) json.addValue(name, value);
  });
  return json.file();
}

std::string loopObj(const LoadedMesh& loaded, const GirthLoop& loop) {
  std::string text;
  std::size_t count = 0;
  appendLine(loaded, loop.points, true, count, text);
  return text;
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
  writer.endMesh(TINYGLTF_MODE_LINE_STRIP, JsonObject()
                                               .add("length", loop.length)
                                               .add("kind", toString(loop.kind))
                                               .add("angle", loop.angle)
                                               .add("unit", loaded.unit)
                                               .text());
  return writer.file(loaded.unit);
}

}  // namespace girth::io
