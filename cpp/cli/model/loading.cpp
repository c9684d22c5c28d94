#include "model/loading.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include "girth/io/length_unit.h"
#include "girth/subdivide_surface.h"
#include "model/fewer_triangles.h"
#include "model/model_file.h"
#include "process/interrupt.h"
#include "process/report.h"
#include "text/length_text.h"
#include "text/number_text.h"

namespace girth::cli {
namespace {

/// The component that a user named. Components of `parts` are numbered by their place.
Result<Index> componentOf(const std::string& text, const std::vector<SurfacePart>& parts) {
  if (text == "largest") {
    const auto largest = std::max_element(
        parts.begin(), parts.end(),
        [](const SurfacePart& a, const SurfacePart& b) { return a.area < b.area; });
    return static_cast<Index>(largest - parts.begin());
  }
  Index number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || end != text.data() + text.size()) {
    return usageError("\"" + text + "\" is no component",
                      "name one by its number in girth info, or write largest");
  }
  return number;
}

/// 0, 1 or 2: the axis that is upwards. glTF states it, exporters of OBJ keep to it, and for
/// printers (STL) the bed is x and y.
Result<std::size_t> upAxis(const std::string& wished, io::Format format) {
  if (!wished.empty()) return static_cast<std::size_t>(wished.front() - 'x');
  switch (format) {
    case io::Format::Glb:
    case io::Format::Gltf:
    case io::Format::Obj:
      return std::size_t{1};
    case io::Format::Stl:
      return std::size_t{2};
    case io::Format::Ply:
    case io::Format::Off:
      break;
  }
  return usageError(std::string(io::toString(format)) + " does not say which axis is up",
                    "give it with --up x, y or z");
}

double extentAlong(const SurfaceMesh& mesh, std::size_t axis) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    const double at = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    low = std::min(low, at);
    high = std::max(high, at);
  }
  return high - low;
}

/// The unit that is typed replaces the one that the file states, with a note.
void stateUnit(const std::string& path, const std::string& typed, std::string& unit) {
  const io::LengthUnit* known = io::findLengthUnit(typed);
  if (known == nullptr) return;
  if (!unit.empty() && unit != known->name) {
    printNote(path, "the file states " + unit + "; --unit takes its numbers as " +
                        std::string(known->name) +
                        " instead; to have them in another unit, use --in");
  }
  unit = known->name;
}

/// The scale that makes the whole model as high as wished; `unit` becomes that of the wish where it
/// is not known.
Result<double> scaleToHeight(const ModelOptions& options, const io::ReadModel& read,
                             std::string& unit) {
  const auto typed = io::parseLength(options.height);
  if (!typed) return typed.error();
  if (unit.empty() && typed.value().unit != nullptr) unit = typed.value().unit->name;
  const auto height = io::lengthInUnit(options.height, unit);
  if (!height) return height.error();
  const auto axis = upAxis(options.up, read.format);
  if (!axis) return axis.error();
  const auto whole = prepareSurface(read.soup);
  if (!whole) return whole.error();
  const double present = extentAlong(whole.value().mesh, axis.value());
  if (!(present > 0) || !(height.value() > 0)) {
    return usageError("\"" + options.height + "\" is no height that this model can have",
                      "name another axis with --up, or give a scale with --scale");
  }
  return height.value() / present;
}

}  // namespace

Result<io::ReadModel> readModelFile(const std::string& path, const std::string& entry,
                                    const io::ReadOptions& reading) {
  const auto file = openModel(path, entry);
  if (!file) return file.error();
  return io::readModel(file.value().bytes, file.value().name, file.value().resources, reading);
}

Result<io::LoadedMesh> loadModelWithoutNotes(const std::string& path, const ModelOptions& options,
                                             const io::ReadOptions& reading) {
  auto model = readModelFile(path, options.entry, reading);
  if (!model) return model.error();
  io::ReadModel& read = model.value();
  stateUnit(path, options.unit, read.unit);

  PrepareOptions prepare;
  prepare.closeHoles = options.closeHoles;
  prepare.minComponent = options.minComponent;
  prepare.scale = options.scale;
  if (!options.height.empty()) {
    const auto scale = scaleToHeight(options, read, read.unit);
    if (!scale) return scale.error();
    prepare.scale = scale.value();
  }
  if (const io::LengthUnit* shown = io::findLengthUnit(options.shownUnit)) {
    const io::LengthUnit* own = io::findLengthUnit(read.unit);
    if (own == nullptr) {
      return usageError(
          "the unit of the file's numbers is not known, so they cannot be converted to " +
              options.shownUnit,
          "give it with --unit");
    }
    prepare.scale *= own->metres / shown->metres;
    read.unit = shown->name;
  }
  if (!options.weldDistance.empty()) {
    const auto distance = io::lengthInUnit(options.weldDistance, read.unit);
    if (!distance) return distance.error();
    prepare.weldDistance = distance.value();
  }
  if (!options.components.empty()) {
    // The components are known only once the surface has been prepared.
    const auto all = prepareSurface(read.soup, prepare);
    if (!all) return all.error();
    for (const std::string& text : options.components) {
      const auto component = componentOf(text, all.value().parts);
      if (!component) return component.error();
      prepare.components.push_back(component.value());
    }
  }
  // Attributes belong to the file's triangles.
  const TriangleSoup soup = read.attributes.empty() ? TriangleSoup{} : read.soup;
  auto prepared = prepareSurface(std::move(read.soup), prepare);
  if (!prepared) return prepared.error();
  if (options.subdivide > 0) {
    prepared = subdivideSurface(std::move(prepared).value(), options.subdivide,
                                {0, &catchInterrupts(), {}});
    if (!prepared) return prepared.error();
  }
  std::vector<io::Attribute> attributes;
  if (!read.attributes.empty()) {
    attributes = io::cornerAttributes(read.attributes, soup, prepare.scale, prepared.value());
  }
  io::LoadedMesh loaded{std::move(prepared).value(), read.format,
                        std::move(read.unit),        std::move(read.notes),
                        std::move(attributes),       std::move(read.attributeNotes)};
  if (options.faces == 0) return loaded;
  return inFewerTriangles(path, std::move(loaded), options.faces);
}

Result<io::LoadedMesh> loadModel(const std::string& path, const ModelOptions& options,
                                 const io::ReadOptions& reading) {
  auto loaded = loadModelWithoutNotes(path, options, reading);
  if (!loaded) return loaded;
  const PreparationReport& report = loaded.value().report;
  const Index edges = report.oneSidedEdges;
  if (edges > 0) {
    printNote(path, "the surface has one side only and was cut along " + std::to_string(edges) +
                        (edges == 1 ? " edge" : " edges") + ", which no loop or path crosses");
  }
  if (const std::string note = crackNote(report); !note.empty()) printNote(path, note);
  return loaded;
}

std::string crackNote(const PreparationReport& report) {
  const auto counted = [](Index count, const char* one, const char* many) {
    return std::to_string(count) + (count == 1 ? one : many);
  };
  std::string text;
  if (report.crackVertices > 0) {
    text = counted(report.crackVertices, " boundary vertex nearly coincides with another",
                   " boundary vertices nearly coincide with others");
  }
  if (report.tJunctions > 0) {
    if (!text.empty()) text += ", and ";
    text += counted(report.tJunctions, " boundary vertex lies within the edge of a neighbour",
                    " boundary vertices lie within edges of neighbours");
  }
  if (text.empty()) return text;
  return "the surface is open along cracks: " + text + "; --weld " +
         io::formatNumber(report.crackWidth) + " closes them";
}

Result<Vertex> surfaceVertex(const io::LoadedMesh& loaded, std::int64_t vertex) {
  const std::size_t count = loaded.vertexOfInput.size();
  if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= count) {
    Error error = makeError(ErrorCode::VertexOutOfRange, vertex,
                            "there is no vertex " + std::to_string(vertex));
    error.hint = "its vertices are numbered from 0 to " + std::to_string(count - 1);
    return error;
  }
  const Index found = loaded.vertexOfInput[static_cast<std::size_t>(vertex)];
  if (found == kNoIndex) {
    Error error = makeError(ErrorCode::VertexOutOfRange, vertex,
                            "no face uses vertex " + std::to_string(vertex));
    error.hint = "name a vertex of a face";
    return error;
  }
  return Vertex(found);
}

std::string numberInFile(const io::LoadedMesh& loaded, Index vertex) {
  const Index input = loaded.inputOfVertex[vertex];
  return input == kNoIndex ? "(made here)" : std::to_string(input);
}

}  // namespace girth::cli
