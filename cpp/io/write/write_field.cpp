#include "girth/io/write_field.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "bytes/append.h"
#include "girth/io/json_text.h"
#include "girth/io/length_unit.h"
#include "girth/io/result_json.h"
#include "picture/viridis.h"
#include "text/number_text.h"
#include "text/unit_text.h"
#include "write/glb_writer.h"
#include "write/npy.h"
#include "write/point_json.h"

namespace girth::io {
namespace {

constexpr std::uint8_t kNoValue = 255;

/// Whether a vertex of the file, by its vertex on the surface, has a value.
bool hasValue(const VertexField& field, Vertex vertex) {
  return vertex != Vertex::none && field.has(vertex);
}

constexpr std::array kAxes{"x", "y", "z"};

double coordinate(const SurfaceMesh& mesh, Vertex vertex, std::size_t axis) {
  const Vec3& p = mesh.position(vertex);
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// " (mm)"; nothing where the unit is not known.
std::string unitInColumn(const std::string& unit) {
  if (unit.empty()) return "";
  const LengthUnit* known = findLengthUnit(unit);
  return " (" + (known == nullptr ? unit : std::string(known->symbol)) + ")";
}

/// A value as text has it: a number, or the word for a code.
std::string valueText(const VertexField& field, Vertex vertex) {
  const double value = field.values[vertex];
  if (field.words.empty()) return formatNumber(value);
  return std::string(field.words[static_cast<std::size_t>(value)]);
}

/// The meaning of codes: "0 body, 1 tube".
std::string meaningOfCodes(std::span<const std::string_view> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(i) + " " + std::string(words[i]);
  }
  return text;
}

std::string capitals(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

/// " (metre, exact)", or nothing.
std::string particulars(const VertexField& field) {
  const bool both = !field.unit.empty() && !field.method.empty();
  const std::string text = field.unit + (both ? ", " : "") + field.method;
  return text.empty() ? text : " (" + text + ")";
}

/// A field's name, method, unit and completeness as JSON.
std::string aboutJson(const VertexField& field) {
  JsonObject about;
  about.add("name", field.name).add("method", field.method).add("unit", field.unit);
  if (!field.words.empty()) about.add("codes", meaningOfCodes(field.words));
  return about.add("complete", field.complete()).text();
}

/// The least and the greatest value.
ColourRange rangeOf(const VertexField& field) {
  ColourRange range{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
  for (const double value : field.values) {
    if (!std::isfinite(value)) continue;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range;
}

std::vector<std::uint16_t> coloursOf(const VertexField& field, const ColourRange& range) {
  constexpr std::uint16_t kOpaque = 65535;
  // Half as light as white on a screen.
  constexpr LinearColour kGrey{14027, 14027, 14027};
  std::vector<std::uint16_t> channels;
  channels.reserve(4 * field.values.size());
  const double width = range.high - range.low;
  for (const double value : field.values) {
    const double fraction = width > 0 ? (value - range.low) / width : 0.5;
    const LinearColour colour =
        std::isnan(fraction) || std::isnan(value) ? kGrey : viridis(fraction);
    channels.insert(channels.end(), {colour[0], colour[1], colour[2], kOpaque});
  }
  return channels;
}

/// The loop of a vertex as a line, with what it measures.
void addLoop(GlbWriter& writer, const SurfaceMesh& mesh, const GirthLoop& loop) {
  const std::vector<Vec3> points = polyline(mesh, loop);
  if (points.empty()) return;  // unresolved
  const Index vertex = loop.base.vertex();
  const Vec3 middle = positionOf(mesh, loop.midpoint);
  const std::string measures = JsonObject()
                                   .add("vertex", vertex)
                                   .add("length", loop.length)
                                   .add("kind", girth::toString(loop.kind))
                                   .add("angle", loop.angle)
                                   .addJson("midpoint", "[" + pointText(middle, ',') + "]")
                                   .text();
  writer.addPositions(points);
  writer.endMesh(TINYGLTF_MODE_LINE_STRIP, JsonObject().addJson("loop", measures).text(),
                 "loop " + std::to_string(vertex));
}

/// Adds `tips` and `crossedEdges` to a surface's extras.
void addTips(const Tips& tips, JsonObject& extras) {
  JsonList list;
  for (const Tip& tip : tips.tips) {
    JsonList vertices;
    for (const Vertex v : tip.vertices) vertices.add(std::to_string(Index(v)));
    list.add(JsonObject()
                 .addJson("vertices", vertices.text())
                 .add("area", tip.area)
                 .add("boundaryLength", tip.boundaryLength)
                 .add("apex", Index(tip.apex))
                 .add("apexDistance", tip.apexDistance)
                 .add("jump", tip.jump)
                 .text());
  }
  extras.addJson("tips", list.text()).add("crossedEdges", tips.crossedEdges);
}

/// A line of a contour; a closed one ends with its first point.
void addContour(GlbWriter& writer, const SurfaceMesh& mesh, const ContourLine& line,
                const std::string& extras, const std::string& name) {
  std::vector<Vec3> points;
  points.reserve(line.points.size() + 1);
  for (const SurfacePoint& point : line.points) points.push_back(positionOf(mesh, point));
  if (points.empty()) return;
  if (line.closed) points.push_back(points.front());
  writer.addPositions(points);
  writer.endMesh(TINYGLTF_MODE_LINE_STRIP, extras, name);
}

void addContours(GlbWriter& writer, const SurfaceMesh& mesh, const Tips& tips) {
  for (std::size_t i = 0; i < tips.tips.size(); ++i) {
    for (const ContourLine& line : tips.tips[i].contour) {
      const std::string what = JsonObject().add("tip", i).add("closed", line.closed).text();
      addContour(writer, mesh, line, JsonObject().addJson("contour", what).text(),
                 "tip " + std::to_string(i));
    }
  }
  for (std::size_t i = 0; i < tips.arcs.size(); ++i) {
    const OpenArc& arc = tips.arcs[i];
    const std::string what = JsonObject().add("length", arc.length).add("jump", arc.jump).text();
    addContour(writer, mesh, arc.line, JsonObject().addJson("arc", what).text(),
               "arc " + std::to_string(i));
  }
}

}  // namespace

std::string fieldCsv(const LoadedMesh& loaded, std::span<const VertexField> fields,
                     Columns columns) {
  const bool hasPositions = columns == Columns::Positions;
  std::string text = "vertex";
  for (std::size_t axis = 0; hasPositions && axis < kAxes.size(); ++axis) {
    text += std::string(",") + kAxes[axis] + unitInColumn(loaded.unit);
  }
  for (const VertexField& field : fields) {
    text += "," + field.name + (hasPositions ? unitInColumn(field.unit) : "");
    if (!field.kinds.empty()) text += "," + field.kindName;
  }
  text += "\n";
  for (std::size_t input = 0; input < loaded.vertexOfInput.size(); ++input) {
    const Vertex vertex = loaded.vertexOfInput[input];
    text += std::to_string(input);
    for (std::size_t axis = 0; hasPositions && axis < kAxes.size(); ++axis) {
      text += ",";
      if (vertex != Vertex::none) text += formatNumber(coordinate(loaded.mesh, vertex, axis));
    }
    for (const VertexField& field : fields) {
      const bool has = hasValue(field, vertex);
      text += ",";
      if (has) text += valueText(field, vertex);
      if (!field.kinds.empty()) text += ",";
      if (!field.kinds.empty() && has) text += girth::toString(field.kinds[vertex]);
    }
    text += "\n";
  }
  return text;
}

std::string fieldJson(const LoadedMesh& loaded, std::span<const VertexField> fields,
                      std::string_view file, Columns wanted) {
  JsonList about;
  std::vector<std::pair<std::string, std::string>> columns;
  bool complete = true;
  const auto column = [&](const std::string& name, const auto& textAt) {
    JsonList texts;
    for (const Vertex vertex : loaded.vertexOfInput) texts.add(textAt(vertex));
    columns.emplace_back(name, texts.text());
  };
  for (std::size_t axis = 0; wanted == Columns::Positions && axis < kAxes.size(); ++axis) {
    column(kAxes[axis], [&](Vertex vertex) {
      return vertex == Vertex::none ? std::string("null")
                                    : formatNumber(coordinate(loaded.mesh, vertex, axis));
    });
  }
  for (const VertexField& field : fields) {
    about.add(aboutJson(field));
    complete = complete && field.complete();
    column(field.name, [&](Vertex vertex) {
      if (!hasValue(field, vertex) || !std::isfinite(field.values[vertex])) {
        return std::string("null");
      }
      const std::string text = valueText(field, vertex);
      return field.words.empty() ? text : jsonString(text);
    });
    if (field.kinds.empty()) continue;
    column(field.kindName, [&](Vertex vertex) {
      return hasValue(field, vertex) ? jsonString(girth::toString(field.kinds[vertex]))
                                     : std::string("null");
    });
  }
  ResultJson json(file, loaded);
  json.add("complete", complete)
      .add("vertices", loaded.vertexOfInput.size())
      .addJson("fields", about.text());
  for (const auto& [name, texts] : columns) json.addJsonLine(name, texts);
  return json.file();
}

std::string fieldNpy(const LoadedMesh& loaded, const VertexField& field) {
  std::string content = npyHeader(std::to_string(loaded.vertexOfInput.size()) + ",");
  content.reserve(content.size() + 8 * loaded.vertexOfInput.size());
  for (const Vertex vertex : loaded.vertexOfInput) {
    appendDouble(content, vertex == kNoIndex ? std::numeric_limits<double>::quiet_NaN()
                                             : field.values[vertex]);
  }
  return content;
}

std::string fieldPly(const LoadedMesh& loaded, std::span<const VertexField> fields) {
  const SurfaceMesh& mesh = loaded.mesh;
  std::string content =
      "ply\nformat binary_little_endian 1.0\n" + unitComment("comment", loaded.unit);
  std::string properties;
  std::size_t vertexSize = 24;
  for (const VertexField& field : fields) {
    content += "comment " + field.name + particulars(field) +
               (field.words.empty() ? "" : ": " + meaningOfCodes(field.words)) + "\n";
    properties += "property double " + field.name + "\n";
    vertexSize += 8;
    if (field.kinds.empty()) continue;
    content += "comment " + field.kindName + ": 0 loop, 1 antipodal, 2 unresolved, 255 no value\n";
    properties += "property uchar " + field.kindName + "\n";
    vertexSize += 1;
  }
  content += "element vertex " + std::to_string(mesh.vertexCount()) +
             "\nproperty double x\nproperty double y\nproperty double z\n" + properties +
             "element face " + std::to_string(mesh.faceCount()) +
             "\nproperty list uchar int vertex_indices\nend_header\n";
  content.reserve(content.size() + vertexSize * mesh.vertexCount() +
                  13 * std::size_t{mesh.faceCount()});
  for (const Vertex v : mesh.vertices()) {
    const Vec3& position = mesh.position(v);
    appendDouble(content, position.x);
    appendDouble(content, position.y);
    appendDouble(content, position.z);
    for (const VertexField& field : fields) {
      appendDouble(content, field.values[v]);
      if (field.kinds.empty()) continue;
      appendBytes(content, field.has(v) ? static_cast<std::uint8_t>(field.kinds[v]) : kNoValue, 1);
    }
  }
  for (const Face f : mesh.faces()) {
    appendBytes(content, 3, 1);
    for (const Vertex v : mesh.faceVertices(f)) appendBytes(content, v, 4);
  }
  return content;
}

Result<std::string> fieldGlb(const LoadedMesh& loaded, std::span<const VertexField> fields,
                             std::optional<ColourRange> range, const LinesOnSurface& lines) {
  const SurfaceMesh& mesh = loaded.mesh;
  GlbWriter writer;
  std::vector<Vec3> positions;
  positions.reserve(mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) positions.push_back(mesh.position(v));
  writer.addPositions(positions);
  if (!fields.empty()) writer.addColours(coloursOf(fields[0], range ? *range : rangeOf(fields[0])));
  JsonObject about;
  for (const VertexField& field : fields) {
    const std::string attribute = "_" + capitals(field.name);
    about.addJson(attribute, aboutJson(field));
    writer.addValues(attribute, field.values);
    if (field.kinds.empty()) continue;
    std::vector<double> kinds(field.values.size(), -1);
    for (const Vertex v : mesh.vertices()) {
      if (field.has(v)) kinds[v] = static_cast<double>(field.kinds[v]);
    }
    writer.addValues("_" + capitals(field.kindName), kinds);
  }
  writer.addTriangles(mesh);
  JsonObject extras;
  extras.add("unit", loaded.unit).addJson("fields", about.text());
  if (lines.tips != nullptr) addTips(*lines.tips, extras);
  writer.endMesh(TINYGLTF_MODE_TRIANGLES, extras.text());
  for (const GirthLoop& loop : lines.loops) addLoop(writer, mesh, loop);
  if (lines.tips != nullptr) addContours(writer, mesh, *lines.tips);
  return writer.file(loaded.unit);
}

Result<std::string> fieldFile(const LoadedMesh& loaded, std::span<const VertexField> fields,
                              std::string_view format, std::string_view file, Columns columns) {
  if (auto error = checkFields(loaded, fields)) return *std::move(error);
  if (format == "csv") return fieldCsv(loaded, fields, columns);
  if (format == "json") return fieldJson(loaded, fields, file, columns);
  if (format == "ply") return fieldPly(loaded, fields);
  if (format == "glb") return fieldGlb(loaded, fields);
  if (format != "npy") {
    Error error = makeError(ErrorCode::Usage, -1,
                            format.empty() ? "the file's name has no ending"
                                           : "fields are not written as " + std::string(format));
    error.hint = "use .csv, .json, .npy, .ply or .glb";
    return error;
  }
  if (fields.size() == 1) return fieldNpy(loaded, fields[0]);
  Error error = makeError(ErrorCode::Usage, -1, "NPY holds one number for each vertex here");
  error.hint = "choose one field, or use .csv, .json, .ply or .glb";
  return error;
}

}  // namespace girth::io
