#include "girth/io/write_necks.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "girth/describe/necks.h"
#include "girth/io/result_json.h"
#include "text/number_text.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {
namespace {

std::string wordOf(bool value) { return value ? "true" : "false"; }

}  // namespace

std::string necksJson(const LoadedMesh& loaded, const Necks& necks, std::string_view file) {
  return resultJson(loaded, necks, file);
}

std::string necksCsv(const LoadedMesh& loaded, const Necks& necks) {
  std::string text =
      "neck,length,prominence,width,area,radius,x,y,z,normalX,normalY,normalZ,measuresGirth,unit\n";
  for (std::size_t i = 0; i < necks.necks.size(); ++i) {
    const Neck& neck = necks.necks[i];
    text += std::to_string(i) + "," + formatNumber(neck.length) + "," +
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
    text += "o neck_" + std::to_string(i) + "\n";
    appendLine(loaded, necks.necks[i].points, true, count, text);
  }
  return text;
}

Result<std::string> necksGlb(const LoadedMesh& loaded, const Necks& necks) {
  GlbWriter writer;
  for (std::size_t i = 0; i < necks.necks.size(); ++i) {
    const Neck& neck = necks.necks[i];
    addLine(loaded, neck.points,
            JsonObject()
                .add("length", neck.length)
                .add("prominence", neck.prominence)
                .add("area", neck.area)
                .add("unit", loaded.unit)
                .text(),
            "neck_" + std::to_string(i), writer);
  }
  return writer.file(loaded.unit);
}

}  // namespace girth::io
