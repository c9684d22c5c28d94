#include "girth/io/write_tips.h"

#include <cstddef>

#include "text/json_text.h"
#include "text/number_text.h"
#include "write/point_json.h"

namespace girth::io {
namespace {

std::string lineJson(const LoadedMesh& loaded, const ContourLine& line) {
  std::string points;
  for (const SurfacePoint& point : line.points) {
    points += (points.empty() ? "[" : ",[") + pointText(positionOf(loaded.mesh, point), ',') + "]";
  }
  return std::string("{\"closed\":") + (line.closed ? "true" : "false") + ",\"points\":[" + points +
         "]}";
}

std::string tipJson(const LoadedMesh& loaded, const Tip& tip) {
  std::string contour;
  for (const ContourLine& line : tip.contour) {
    contour += (contour.empty() ? "" : ",") + lineJson(loaded, line);
  }
  return "{\"area\":" + formatNumber(tip.area) +
         ",\"boundaryLength\":" + formatNumber(tip.boundaryLength) +
         ",\"jump\":" + formatNumber(tip.jump) +
         ",\"apex\":" + pointJson(loaded, SurfacePoint::atVertex(tip.apex)) +
         ",\"apexDistance\":" + formatNumber(tip.apexDistance) +
         ",\"vertices\":" + inputsJson(loaded, tip.vertices) + ",\"contour\":[" + contour + "]}";
}

std::string arcJson(const LoadedMesh& loaded, const OpenArc& arc) {
  return "{\"length\":" + formatNumber(arc.length) + ",\"jump\":" + formatNumber(arc.jump) +
         ",\"line\":" + lineJson(loaded, arc.line) + "}";
}

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
  std::string text = modelJson(file, loaded) + persistenceJson(persistence) +
                     ",\"crossedEdges\":" + std::to_string(tips.crossedEdges) + ",\"tips\":[";
  for (std::size_t i = 0; i < tips.tips.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + tipJson(loaded, tips.tips[i]);
  }
  text += "],\"arcs\":[";
  for (std::size_t i = 0; i < tips.arcs.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + arcJson(loaded, tips.arcs[i]);
  }
  text += "]";
  if (!trials.empty()) text += ",\"trials\":" + std::string(trials);
  return text + "}\n";
}

std::string tipsObj(const LoadedMesh& loaded, const Tips& tips) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < tips.tips.size(); ++i) {
    text += "o tip_" + std::to_string(i + 1) + "\n";
    for (const ContourLine& line : tips.tips[i].contour) appendLine(loaded, line, count, text);
  }
  for (std::size_t i = 0; i < tips.arcs.size(); ++i) {
    text += "o arc_" + std::to_string(i + 1) + "\n";
    appendLine(loaded, tips.arcs[i].line, count, text);
  }
  return text;
}

}  // namespace girth::io
