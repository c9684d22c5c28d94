#include "girth/io/write_cut.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "girth/io/result_json.h"
#include "girth/io/write_mesh.h"
#include "text/unit_text.h"
#include "write/attributed_part.h"
#include "write/glb_writer.h"
#include "write/part_json.h"

namespace girth::io {
namespace {

std::string nameOf(std::size_t part) { return "part_" + std::to_string(part); }

/// A channel of a screen's colour, in proportion to light.
double linearOf(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

/// Red, green, blue and alpha of each vertex, as glTF has them.
std::vector<double> channelsOf(const Attribute& colours) {
  constexpr double kGrey = 0.5;
  std::vector<double> channels;
  for (std::size_t at = 0; at < colours.values.size(); at += colours.width) {
    for (std::size_t i = 0; i < 4; ++i) {
      double value = i < colours.width ? colours.values[at + i] : 1;
      if (std::isnan(value)) value = i < 3 ? kGrey : 1;
      value = std::clamp(value, 0.0, 1.0);
      channels.push_back(i < 3 && !colours.isLinear ? linearOf(value) : value);
    }
  }
  return channels;
}

/// Adds a part with its attributes as a mesh.
void addPart(const LoadedMesh& loaded, const CutModel& model, std::size_t number,
             const std::string& name, GlbWriter& writer) {
  const AttributedPart part = attributedPart(loaded, model, number);
  writer.addPositions(part.places);
  for (const Attribute& attribute : part.attributes) {
    if (attribute.name == "COLOR_0") {
      writer.addColours(channelsOf(attribute));
    } else {
      writer.addValues(attribute.name, attribute.values, attribute.width);
    }
  }
  writer.addTriangles(part.triangles);
  writer.endMesh(TINYGLTF_MODE_TRIANGLES, JsonObject().add("unit", loaded.unit).text(), name);
}

}  // namespace

ResultJson partJson(const SurfaceMesh& part) {
  ResultJson json;
  json.addMembers(partMeasures(part))
      .addValue("faces", part.faceCount())
      .addValue("vertices", part.vertexCount());
  return json;
}

CutModel cutModel(const CutSurface& cut) {
  CutModel model{partsOf(cut.mesh), cut.faces, cut.points};
  std::stable_sort(model.parts.begin(), model.parts.end(),
                   [](const SurfaceComponent& a, const SurfaceComponent& b) {
                     return a.mesh.area() > b.mesh.area();
                   });
  return model;
}

Result<std::string> cutGlb(const LoadedMesh& loaded, const CutModel& model) {
  GlbWriter writer;
  for (std::size_t i = 0; i < model.parts.size(); ++i) addPart(loaded, model, i, nameOf(i), writer);
  return writer.file(loaded.unit);
}

std::string cutObj(const LoadedMesh& loaded, const CutModel& model) {
  std::string text = unitComment("#", loaded.unit);
  std::size_t before = 0;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    text += "o " + nameOf(i) + "\n";
    const AttributedPart part = attributedPart(loaded, model, i);
    appendObj(part, before, text);
    before += part.places.size();
  }
  return text;
}

Result<std::string> partFile(const LoadedMesh& loaded, const CutModel& model, std::size_t part,
                             Format format) {
  if (!loaded.attributes.empty() && format == Format::Ply) {
    return plyFile(attributedPart(loaded, model, part), loaded.unit);
  }
  if (!loaded.attributes.empty() && format == Format::Obj) {
    std::string text = unitComment("#", loaded.unit);
    appendObj(attributedPart(loaded, model, part), 0, text);
    return text;
  }
  if (!loaded.attributes.empty() && format == Format::Glb) {
    GlbWriter writer;
    addPart(loaded, model, part, "", writer);
    return writer.file(loaded.unit);
  }
  return meshFile(model.parts[part].mesh, format, loaded.unit);
}

std::string cutJson(const LoadedMesh& loaded, const CutModel& model, std::string_view file) {
  JsonList parts(true);
  for (const SurfaceComponent& part : model.parts) parts.add(partJson(part.mesh).text());
  ResultJson json(file, loaded);
  json.addJson("parts", parts.text());
  return json.file();
}

namespace {

/// `numberOf`: of a face of the surface that was cut; of several that have one, the areas count
/// together.
template <class NumberOf>
std::vector<Index> partOfNumbers(const CutModel& model, Index count, NumberOf numberOf) {
  // The most area that a part has of each number, and that part.
  std::vector<std::pair<double, Index>> most(count, {0, kNoIndex});
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    std::vector<std::pair<Index, double>> areas;
    const SurfaceComponent& part = model.parts[i];
    for (const Face f : part.mesh.faces()) {
      const Face whole = model.faces[part.faces[f]];
      if (whole == Face::none || numberOf(whole) == kNoIndex) continue;
      areas.emplace_back(numberOf(whole), part.mesh.area(f));
    }
    std::sort(areas.begin(), areas.end());
    for (std::size_t k = 0; k < areas.size();) {
      double sum = 0;
      const Index number = areas[k].first;
      for (; k < areas.size() && areas[k].first == number; ++k) sum += areas[k].second;
      if (sum > most[number].first) most[number] = {sum, static_cast<Index>(i)};
    }
  }
  std::vector<Index> parts;
  parts.reserve(most.size());
  for (const auto& [area, part] : most) parts.push_back(part);
  return parts;
}

}  // namespace

std::vector<Index> partOfFaces(const LoadedMesh& loaded, const CutModel& model) {
  return partOfNumbers(model, loaded.report.inputFaces,
                       [&](Face face) { return loaded.inputOfFace[face]; });
}

std::vector<Index> partOfFaces(const CutModel& model, Index faceCount) {
  return partOfNumbers(model, faceCount, [](Face face) { return Index{face}; });
}

std::string cutCsv(const LoadedMesh& loaded, const CutModel& model) {
  const std::vector<Index> parts = partOfFaces(loaded, model);
  std::string text = "face,part\n";
  for (std::size_t face = 0; face < parts.size(); ++face) {
    if (parts[face] == kNoIndex) continue;
    text += std::to_string(face) + "," + std::to_string(parts[face]) + "\n";
  }
  return text;
}

}  // namespace girth::io
