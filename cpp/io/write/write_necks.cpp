#include "girth/io/write_necks.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "text/json_text.h"
#include "text/number_text.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {
namespace {

std::string wordOf(bool value) { return value ? "true" : "false"; }

std::string neckJson(const LoadedMesh& loaded, const Neck& neck) {
  return "{\"length\":" + formatNumber(neck.length) +
         ",\"prominence\":" + numberJson(neck.prominence) +
         ",\"width\":" + formatNumber(neck.width) + ",\"area\":" + formatNumber(neck.area) +
         ",\"radius\":" + formatNumber(neck.radius) + ",\"centre\":[" +
         pointText(neck.centre, ',') + "],\"normal\":[" + pointText(neck.normal, ',') +
         "],\"sides\":" + sidesJson(neck.sides) +
         ",\"measuresGirth\":" + wordOf(neck.measuresGirth) +
         ",\"touchesBoundary\":" + wordOf(neck.touchesBoundary) +
         ",\"vertices\":" + inputsJson(loaded, neck.vertices) +
         ",\"points\":" + pointsJson(loaded, neck.points) + "}";
}

}  // namespace

std::string necksJson(const LoadedMesh& loaded, const Necks& necks, std::string_view file) {
  std::string text = modelJson(file, loaded) +
                     ",\"unresolved\":" + std::to_string(necks.unresolved) + ",\"necks\":[";
  for (std::size_t i = 0; i < necks.necks.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + neckJson(loaded, necks.necks[i]);
  }
  return text + "]}\n";
}

std::string necksCsv(const LoadedMesh& loaded, const Necks& necks) {
  std::string text =
      "neck,length,prominence,width,area,radius,x,y,z,normalX,normalY,normalZ,measuresGirth,unit\n";
  for (std::size_t i = 0; i < necks.necks.size(); ++i) {
    const Neck& neck = necks.necks[i];
    text += std::to_string(i + 1) + "," + formatNumber(neck.length) + "," +
            (std::isfinite(neck.prominence) ? formatNumber(neck.prominence) : "") + "," +
            formatNumber(neck.width) + "," + formatNumber(neck.area) + "," +
            formatNumber(neck.radius) + "," + pointText(neck.centre, ',') + "," +
            pointText(neck.normal, ',') + "," + wordOf(neck.measuresGirth) + "," + loaded.unit +
            "\n";
  }
  return text;
}

std::string necksObj(const LoadedMesh& loaded, const Necks& necks) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < necks.necks.size(); ++i) {
    text += "o neck_" + std::to_string(i + 1) + "\n";
    appendClosedLine(loaded, necks.necks[i].points, count, text);
  }
  return text;
}

Result<std::string> necksGlb(const LoadedMesh& loaded, const Necks& necks) {
  GlbWriter writer;
  for (std::size_t i = 0; i < necks.necks.size(); ++i) {
    const Neck& neck = necks.necks[i];
    addLine(loaded, neck.points,
            "{\"length\":" + formatNumber(neck.length) + ",\"prominence\":" +
                numberJson(neck.prominence) + ",\"area\":" + formatNumber(neck.area) +
                ",\"unit\":" + jsonString(loaded.unit) + "}",
            "neck_" + std::to_string(i + 1), writer);
  }
  return writer.file(loaded.unit);
}

}  // namespace girth::io
