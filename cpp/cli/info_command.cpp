#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

#include "commands.h"
#include "files.h"
#include "girth/io/json_text.h"
#include "girth/io/number_text.h"
#include "report.h"

namespace girth::cli {
namespace {

struct Box {
  std::array<double, 3> low, high;
};

Box boundingBox(const SurfaceMesh& mesh) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3& p = mesh.position(v);
    const std::array<double, 3> position{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], position[k]);
      box.high[k] = std::max(box.high[k], position[k]);
    }
  }
  return box;
}

std::string joinedNumbers(const std::array<double, 3>& numbers) {
  return "[" + io::formatNumber(numbers[0]) + "," + io::formatNumber(numbers[1]) + "," +
         io::formatNumber(numbers[2]) + "]";
}

std::string joinedGenera(const SurfaceMesh& mesh, const char* separator) {
  std::string text;
  for (Index c = 0; c < mesh.componentCount(); ++c) {
    text += (c == 0 ? "" : separator) + std::to_string(mesh.genus(c));
  }
  return text;
}

void printJson(const std::string& file, const io::LoadedMesh& loaded) {
  const SurfaceMesh& mesh = loaded.mesh;
  const Box box = boundingBox(mesh);
  const std::string text =
      "{\"file\":" + io::jsonString(file) +
      ",\"format\":" + io::jsonString(io::toString(loaded.format)) +
      ",\"unit\":" + io::jsonString(loaded.unit) +
      ",\"fileVertices\":" + std::to_string(loaded.vertexOfInput.size()) +
      ",\"weldedVertices\":" + std::to_string(loaded.report.weldedVertices) +
      ",\"unreferencedVertices\":" + std::to_string(loaded.report.unreferencedVertices) +
      ",\"vertices\":" + std::to_string(mesh.vertexCount()) +
      ",\"edges\":" + std::to_string(mesh.edgeCount()) +
      ",\"faces\":" + std::to_string(mesh.faceCount()) +
      ",\"components\":" + std::to_string(mesh.componentCount()) + ",\"genus\":[" +
      joinedGenera(mesh, ",") + "],\"area\":" + io::formatNumber(mesh.area()) +
      ",\"meanEdgeLength\":" + io::formatNumber(mesh.meanEdgeLength()) +
      ",\"boundingBox\":{\"min\":" + joinedNumbers(box.low) +
      ",\"max\":" + joinedNumbers(box.high) + "}}\n";
  std::fputs(text.c_str(), stdout);
}

void printText(const std::string& file, const io::LoadedMesh& loaded) {
  const SurfaceMesh& mesh = loaded.mesh;
  const Box box = boundingBox(mesh);
  const std::string unit = unitSuffix(loaded.unit);
  const auto row = [](const char* name, const std::string& value) {
    std::printf("  %-14s %s\n", name, value.c_str());
  };
  std::string vertices = std::to_string(mesh.vertexCount());
  if (loaded.report.weldedVertices + loaded.report.unreferencedVertices > 0) {
    vertices += " (of " + std::to_string(loaded.vertexOfInput.size()) + " in the file, " +
                std::to_string(loaded.report.weldedVertices) + " welded, " +
                std::to_string(loaded.report.unreferencedVertices) + " not used by any face)";
  }
  std::printf("%s: closed surface, %s\n", file.c_str(),
              std::string(io::toString(loaded.format)).c_str());
  row("vertices", vertices);
  row("edges", std::to_string(mesh.edgeCount()));
  row("faces", std::to_string(mesh.faceCount()));
  row("components", std::to_string(mesh.componentCount()));
  row("genus", joinedGenera(mesh, ", "));
  row("area", readable(mesh.area()) + (unit.empty() ? "" : unit + "²"));
  row("mean edge", readable(mesh.meanEdgeLength()) + unit);
  row("size", readable(box.high[0] - box.low[0]) + " × " + readable(box.high[1] - box.low[1]) +
                  " × " + readable(box.high[2] - box.low[2]) + unit);
}

}  // namespace

int runInfo(const InfoOptions& options) {
  int exitCode = 0;
  for (const std::string& model : options.models) {
    const auto loaded = loadModel(model);
    if (!loaded) {
      exitCode = std::max(exitCode, reportError(model, loaded.error()));
    } else if (options.json) {
      printJson(model, loaded.value());
    } else {
      printText(model, loaded.value());
    }
  }
  return exitCode;
}

}  // namespace girth::cli
