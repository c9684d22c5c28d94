#include "girth/io/write_cut.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "text/json_text.h"
#include "text/number_text.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {
namespace {

std::string nameOf(std::size_t part) { return "part_" + std::to_string(part + 1); }

}  // namespace

double partVolume(const SurfaceMesh& mesh) {
  if (mesh.boundaryCount(0) > 0) return std::numeric_limits<double>::quiet_NaN();
  double volume = 0;
  const Vec3& o = mesh.position(Vertex(0));
  for (const Face f : mesh.faces()) {
    const auto corners = mesh.faceVertices(f);
    const Vec3 &a = mesh.position(corners[0]), &b = mesh.position(corners[1]),
               &c = mesh.position(corners[2]);
    volume += ((a.x - o.x) * ((b.y - o.y) * (c.z - o.z) - (b.z - o.z) * (c.y - o.y)) +
               (a.y - o.y) * ((b.z - o.z) * (c.x - o.x) - (b.x - o.x) * (c.z - o.z)) +
               (a.z - o.z) * ((b.x - o.x) * (c.y - o.y) - (b.y - o.y) * (c.x - o.x))) /
              6;
  }
  return volume;
}

CutModel cutModel(const CutSurface& cut) {
  CutModel model{componentsOf(cut.mesh), cut.faces};
  std::stable_sort(model.parts.begin(), model.parts.end(),
                   [](const SurfaceComponent& a, const SurfaceComponent& b) {
                     return a.mesh.area() > b.mesh.area();
                   });
  return model;
}

Result<std::string> cutGlb(const LoadedMesh& loaded, const CutModel& model) {
  GlbWriter writer;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const SurfaceMesh& mesh = model.parts[i].mesh;
    std::vector<Vec3> places;
    places.reserve(mesh.vertexCount());
    for (const Vertex v : mesh.vertices()) places.push_back(mesh.position(v));
    writer.addPositions(places);
    writer.addTriangles(mesh);
    writer.endMesh(TINYGLTF_MODE_TRIANGLES, "{\"unit\":" + jsonString(loaded.unit) + "}",
                   nameOf(i));
  }
  return writer.file(loaded.unit);
}

std::string cutObj(const CutModel& model) {
  std::string text;
  Index before = 1;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const SurfaceMesh& mesh = model.parts[i].mesh;
    text += "o " + nameOf(i) + "\n";
    for (const Vertex v : mesh.vertices()) text += "v " + pointText(mesh.position(v), ' ') + "\n";
    for (const Face f : mesh.faces()) {
      text += "f";
      for (const Vertex v : mesh.faceVertices(f)) text += " " + std::to_string(before + v);
      text += "\n";
    }
    before += mesh.vertexCount();
  }
  return text;
}

std::string cutJson(const LoadedMesh& loaded, const CutModel& model, std::string_view file) {
  std::string text =
      "{\"file\":" + jsonString(file) + ",\"unit\":" + jsonString(loaded.unit) + ",\"parts\":[";
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const SurfaceMesh& mesh = model.parts[i].mesh;
    text += (i == 0 ? "\n" : ",\n") + ("{\"area\":" + formatNumber(mesh.area())) +
            ",\"volume\":" + numberJson(partVolume(mesh)) +
            ",\"faces\":" + std::to_string(mesh.faceCount()) +
            ",\"vertices\":" + std::to_string(mesh.vertexCount()) +
            ",\"genus\":" + std::to_string(mesh.genus(0)) +
            ",\"boundaries\":" + std::to_string(mesh.boundaryCount(0)) + "}";
  }
  return text + "]}\n";
}

std::vector<Index> partOfFaces(const LoadedMesh& loaded, const CutModel& model) {
  // Of each face of the file: the most area that a part has in it, and that part.
  std::vector<std::pair<double, Index>> most(loaded.report.inputFaces, {0, kNoIndex});
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    std::vector<std::pair<Index, double>> areas;
    const SurfaceComponent& part = model.parts[i];
    for (const Face f : part.mesh.faces()) {
      const Face whole = model.faces[part.faces[f]];
      if (whole == Face::none || loaded.inputOfFace[whole] == kNoIndex) continue;
      areas.emplace_back(loaded.inputOfFace[whole], part.mesh.area(f));
    }
    std::sort(areas.begin(), areas.end());
    for (std::size_t k = 0; k < areas.size();) {
      double sum = 0;
      const Index face = areas[k].first;
      for (; k < areas.size() && areas[k].first == face; ++k) sum += areas[k].second;
      if (sum > most[face].first) most[face] = {sum, static_cast<Index>(i)};
    }
  }
  std::vector<Index> parts;
  parts.reserve(most.size());
  for (const auto& [area, part] : most) parts.push_back(part);
  return parts;
}

std::string cutCsv(const LoadedMesh& loaded, const CutModel& model) {
  const std::vector<Index> parts = partOfFaces(loaded, model);
  std::string text = "face,part\n";
  for (std::size_t face = 0; face < parts.size(); ++face) {
    if (parts[face] == kNoIndex) continue;
    text += std::to_string(face) + "," + std::to_string(parts[face] + 1) + "\n";
  }
  return text;
}

}  // namespace girth::io
