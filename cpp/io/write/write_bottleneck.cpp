#include "girth/io/write_bottleneck.h"

#include <cstddef>

#include "girth/describe/bottleneck.h"
#include "girth/io/result_json.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {

std::string bottleneckJson(const LoadedMesh& loaded, const Bottleneck& bottleneck,
                           std::string_view file) {
  return resultJson(loaded, bottleneck, file);
}

std::string bottleneckObj(const LoadedMesh& loaded, const Bottleneck& bottleneck) {
  std::string text;
  std::size_t count = 0;
  if (!bottleneck.points.empty()) {
    text += "o bottleneck\n";
    appendLine(loaded, bottleneck.points, true, count, text);
  }
  text += "o way\n";
  std::string line = "l";
  for (const SurfacePoint& point : bottleneck.way) {
    text += "v " + pointText(positionOf(loaded.mesh, point), ' ') + "\n";
    line += " " + std::to_string(++count);
  }
  return text + line + "\n";
}

Result<std::string> bottleneckGlb(const LoadedMesh& loaded, const Bottleneck& bottleneck) {
  GlbWriter writer;
  const std::string_view unit = loaded.unit;
  if (!bottleneck.points.empty()) {
    addLine(loaded, bottleneck.points,
            JsonObject()
                .add("girth", bottleneck.girth)
                .add("kind", toString(bottleneck.kind))
                .add("unit", unit)
                .text(),
            "bottleneck", writer);
  }
  addLine(loaded, bottleneck.way, JsonObject().add("unit", unit).text(), "way", writer);
  return writer.file(loaded.unit);
}

}  // namespace girth::io
