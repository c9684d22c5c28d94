#include "girth/io/write_tips.h"

#include <cstddef>

#include "girth/describe/tips.h"
#include "girth/io/result_json.h"
#include "write/point_json.h"

namespace girth::io {
namespace {

/// Appends vertices and a line element; `count` vertices stand before.
void appendLine(const LoadedMesh& loaded, const ContourLine& line, std::size_t& count,
                std::string& text) {
  std::string element = "l";
  for (const SurfacePoint& point : line.points) {
    text += "v " + pointText(positionOf(loaded.mesh, point), ' ') + "\n";
    element += " " + std::to_string(++count);
  }
  if (line.closed) element += " " + std::to_string(count - line.points.size() + 1);
  if (line.points.size() > 1) text += element + "\n";
}

}  // namespace

std::string tipsJson(const LoadedMesh& loaded, const Tips& tips, std::string_view file,
                     std::string_view trials, double persistence) {
  ResultJson json(file, loaded);
  json.addPersistence(persistence).addMembers(tips);
  if (!trials.empty()) json.addJson("trials", trials);
  return json.file();
}

std::string tipsObj(const LoadedMesh& loaded, const Tips& tips) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < tips.tips.size(); ++i) {
    text += "o tip_" + std::to_string(i) + "\n";
    for (const ContourLine& line : tips.tips[i].contour) appendLine(loaded, line, count, text);
  }
  for (std::size_t i = 0; i < tips.arcs.size(); ++i) {
    text += "o arc_" + std::to_string(i) + "\n";
    appendLine(loaded, tips.arcs[i].line, count, text);
  }
  return text;
}

}  // namespace girth::io
