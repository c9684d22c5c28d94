#include "girth/io/report_json.h"

#include <utility>

#include "text/number_text.h"

namespace girth::io {

std::string reportJson(const PreparationReport& report) {
  std::string text = "{";
  for (const auto& [name, count] :
       {std::pair<const char*, Index>{"inputVertices", report.inputVertices},
        {"inputFaces", report.inputFaces},
        {"weldedVertices", report.weldedVertices},
        {"degenerateFaces", report.degenerateFaces},
        {"addedFaces", report.addedFaces},
        {"flippedFaces", report.flippedFaces},
        {"duplicateFaces", report.duplicateFaces},
        {"unreferencedVertices", report.unreferencedVertices},
        {"reorientedFaces", report.reorientedFaces},
        {"oneSidedEdges", report.oneSidedEdges},
        {"nonManifoldEdges", report.nonManifoldEdges},
        {"nonManifoldVertices", report.nonManifoldVertices},
        {"addedVertices", report.addedVertices},
        {"components", report.components},
        {"sliverComponents", report.sliverComponents},
        {"doubledComponents", report.doubledComponents},
        {"keptComponents", report.keptComponents},
        {"boundaryCurves", report.boundaryCurves},
        {"boundaryEdges", report.boundaryEdges},
        {"crackVertices", report.crackVertices},
        {"tJunctions", report.tJunctions},
        {"closedHoles", report.closedHoles}}) {
    text += "\"" + std::string(name) + "\":" + std::to_string(count) + ",";
  }
  text += "\"crackWidth\":" + formatNumber(report.crackWidth) + ",";
  std::string holes;
  for (const ClosedHole& hole : report.holes) {
    holes +=
        std::string(holes.empty() ? "" : ",") + "{\"edges\":" + std::to_string(hole.edges) +
        ",\"perimeter\":" + formatNumber(hole.perimeter) + ",\"area\":" + formatNumber(hole.area) +
        ",\"vertex\":" + (hole.vertex == kNoIndex ? "null" : std::to_string(hole.vertex)) + "}";
  }
  return text + "\"holes\":[" + holes + "]}";
}

}  // namespace girth::io
