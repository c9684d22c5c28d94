#include "girth/io/write_limb_axis.h"

#include <cstddef>

#include "girth/describe/limb_axis.h"
#include "girth/io/result_csv.h"
#include "girth/io/result_json.h"
#include "text/number_text.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {

std::string limbAxisCsv(const LoadedMesh& loaded, std::span<const AxisStation> axis) {
  ResultCsv<AxisStation> csv(loaded);
  for (const AxisStation& station : axis) csv.add(station);
  return csv.text();
}

std::string limbAxisJson(const LoadedMesh& loaded, std::span<const AxisStation> axis,
                         std::string_view file) {
  return ResultJson(file, loaded)
      .addValue("length", axis.empty() ? 0 : axis.back().distance)
      .addValue("loops", axis)
      .file();
}

std::string limbAxisObj(const LoadedMesh& loaded, std::span<const AxisStation> axis) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    text += "o loop_" + std::to_string(i) + "\n";
    appendLine(loaded, axis[i].points, true, count, text);
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
            JsonObject()
                .add("girth", axis[i].girth)
                .add("distance", axis[i].distance)
                .add("unit", loaded.unit)
                .text(),
            "loop_" + std::to_string(i), writer);
  }
  return writer.file(loaded.unit);
}

}  // namespace girth::io
