#include "girth/io/write_field.h"

#include <cmath>
#include <cstdint>

#include "bit_cast.h"
#include "girth/io/json_text.h"
#include "girth/io/number_text.h"

namespace girth::io {
namespace {

constexpr std::uint8_t kNotComputed = 255;

bool isComputed(const GirthField& field, Index vertex) {
  return vertex != kNoIndex && !std::isnan(field.values[vertex]);
}

void appendLittleEndian(std::string& bytes, std::uint64_t bits, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xFFu);
}

void appendDouble(std::string& bytes, double value) {
  appendLittleEndian(bytes, bitCast<std::uint64_t>(value), 8);
}

}  // namespace

std::string_view toString(GirthMethod method) {
  return method == GirthMethod::Naive ? "naive" : "exact";
}

std::string fieldCsv(const LoadedMesh& loaded, const GirthField& field) {
  std::string text = "vertex,igf,kind\n";
  for (std::size_t input = 0; input < loaded.vertexOfInput.size(); ++input) {
    const Index vertex = loaded.vertexOfInput[input];
    text += std::to_string(input) + ",";
    if (isComputed(field, vertex)) {
      text += formatNumber(field.values[vertex]) + "," +
              std::string(girth::toString(field.kinds[vertex])) + "\n";
    } else {
      text += ",\n";
    }
  }
  return text;
}

std::string fieldJson(const LoadedMesh& loaded, const GirthField& field,
                      const FieldOrigin& origin) {
  std::string values;
  std::string kinds;
  for (const Index vertex : loaded.vertexOfInput) {
    const char* separator = values.empty() ? "" : ",";
    const bool computed = isComputed(field, vertex);
    values += separator + (computed ? formatNumber(field.values[vertex]) : "null");
    kinds += separator +
             (computed ? jsonString(girth::toString(field.kinds[vertex])) : std::string("null"));
  }
  return "{\"file\":" + jsonString(origin.file) +
         ",\"field\":\"igf\",\"method\":" + jsonString(toString(origin.method)) +
         ",\"unit\":" + jsonString(loaded.unit) +
         ",\"complete\":" + (field.complete() ? "true" : "false") +
         ",\"vertices\":" + std::to_string(loaded.vertexOfInput.size()) + ",\n\"igf\":[" + values +
         "],\n\"kind\":[" + kinds + "]}\n";
}

std::string fieldPly(const LoadedMesh& loaded, const GirthField& field) {
  const SurfaceMesh& mesh = loaded.mesh;
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\n"
      "comment igf: the intrinsic girth function; kind: 0 loop, 1 antipodal, 255 not computed\n"
      "element vertex " +
      std::to_string(mesh.vertexCount()) +
      "\nproperty double x\nproperty double y\nproperty double z\n"
      "property double igf\nproperty uchar kind\n"
      "element face " +
      std::to_string(mesh.faceCount()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3& position = mesh.position(v);
    appendDouble(bytes, position.x);
    appendDouble(bytes, position.y);
    appendDouble(bytes, position.z);
    appendDouble(bytes, field.values[v]);
    appendLittleEndian(
        bytes, isComputed(field, v) ? static_cast<std::uint8_t>(field.kinds[v]) : kNotComputed, 1);
  }
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    appendLittleEndian(bytes, 3, 1);
    for (const Index v : mesh.faceVertices(f)) appendLittleEndian(bytes, v, 4);
  }
  return bytes;
}

}  // namespace girth::io
