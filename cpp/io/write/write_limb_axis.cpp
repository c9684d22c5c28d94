#include "girth/io/write_limb_axis.h"

#include <cstddef>

#include "text/json_text.h"
#include "text/number_text.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {

std::string limbAxisCsv(const LoadedMesh& loaded, std::span<const AxisStation> axis) {
  std::string text = "distance,along,girth,area,x,y,z,unit\n";
  for (const AxisStation& station : axis) {
    text += formatNumber(station.distance) + "," + formatNumber(station.along) + "," +
            formatNumber(station.girth) + "," + formatNumber(station.area) + "," +
            pointText(station.centre, ',') + "," + loaded.unit + "\n";
  }
  return text;
}

std::string limbAxisJson(const LoadedMesh& loaded, std::span<const AxisStation> axis,
                         std::string_view file) {
  std::string text = modelJson(file, loaded) +
                     ",\"length\":" + formatNumber(axis.empty() ? 0 : axis.back().distance) +
                     ",\"loops\":[";
  const char* separator = "\n";
  for (const AxisStation& station : axis) {
    text +=
        separator + ("{\"distance\":" + formatNumber(station.distance)) +
        ",\"along\":" + formatNumber(station.along) + ",\"girth\":" + formatNumber(station.girth) +
        ",\"area\":" + formatNumber(station.area) + ",\"centre\":[" +
        pointText(station.centre, ',') + "],\"points\":" + pointsJson(loaded, station.points) + "}";
    separator = ",\n";
  }
  return text + "]}\n";
}

std::string limbAxisObj(const LoadedMesh& loaded, std::span<const AxisStation> axis) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    text += "o loop_" + std::to_string(i + 1) + "\n";
    appendClosedLine(loaded, axis[i].points, count, text);
  }
  if (axis.empty()) return text;
  text += "o axis\n";
  for (const AxisStation& station : axis) text += "v " + pointText(station.centre, ' ') + "\n";
  text += "l";
  for (std::size_t i = 0; i < axis.size(); ++i) text += " " + std::to_string(++count);
  return text + "\n";
}

Result<std::string> limbAxisGlb(const LoadedMesh& loaded, std::span<const AxisStation> axis) {
  GlbWriter writer;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    addLine(loaded, axis[i].points,
            "{\"girth\":" + formatNumber(axis[i].girth) + ",\"distance\":" +
                formatNumber(axis[i].distance) + ",\"unit\":" + jsonString(loaded.unit) + "}",
            "loop_" + std::to_string(i + 1), writer);
  }
  return writer.file(loaded.unit);
}

}  // namespace girth::io
