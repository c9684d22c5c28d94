#include "girth/io/write_bottleneck.h"

#include <cstddef>

#include "text/json_text.h"
#include "text/number_text.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {

std::string bottleneckJson(const LoadedMesh& loaded, const Bottleneck& bottleneck,
                           std::string_view file) {
  return modelJson(file, loaded) + ",\"kind\":" + jsonString(toString(bottleneck.kind)) +
         ",\"girth\":" + formatNumber(bottleneck.girth) +
         ",\"place\":" + pointJson(loaded, bottleneck.place) + ",\"centre\":[" +
         pointText(bottleneck.centre, ',') + "],\"area\":" + formatNumber(bottleneck.area) +
         ",\"sides\":" + sidesJson(bottleneck.sides) +
         ",\"points\":" + pointsJson(loaded, bottleneck.points) +
         ",\"way\":" + pointsJson(loaded, bottleneck.way) + "}\n";
}

std::string bottleneckObj(const LoadedMesh& loaded, const Bottleneck& bottleneck) {
  std::string text;
  std::size_t count = 0;
  if (!bottleneck.points.empty()) {
    text += "o bottleneck\n";
    appendClosedLine(loaded, bottleneck.points, count, text);
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
  const std::string unit = jsonString(loaded.unit);
  if (!bottleneck.points.empty()) {
    addLine(loaded, bottleneck.points,
            "{\"girth\":" + formatNumber(bottleneck.girth) +
                ",\"kind\":" + jsonString(toString(bottleneck.kind)) + ",\"unit\":" + unit + "}",
            "bottleneck", writer);
  }
  addLine(loaded, bottleneck.way, "{\"unit\":" + unit + "}", "way", writer);
  return writer.file(loaded.unit);
}

}  // namespace girth::io
