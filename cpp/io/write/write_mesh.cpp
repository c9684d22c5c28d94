#include "girth/io/write_mesh.h"

#include <array>
#include <cmath>
#include <vector>

#include "bytes/append.h"
#include "girth/io/json_text.h"
#include "text/number_text.h"
#include "text/unit_text.h"
#include "write/glb_writer.h"

namespace girth::io {
namespace {

std::string positionText(const Vec3& position) {
  return formatNumber(position.x) + " " + formatNumber(position.y) + " " +
         formatNumber(position.z) + "\n";
}

std::string objFile(const SurfaceMesh& mesh, std::string_view unit) {
  std::string text = unitComment("#", unit);
  for (const Vertex v : mesh.vertices()) text += "v " + positionText(mesh.position(v));
  for (const Face f : mesh.faces()) {
    text += "f";
    for (const Vertex v : mesh.faceVertices(f)) text += " " + std::to_string(std::uint64_t{v} + 1);
    text += "\n";
  }
  return text;
}

std::string offFile(const SurfaceMesh& mesh, std::string_view unit) {
  std::string text = "OFF\n" + unitComment("#", unit) + std::to_string(mesh.vertexCount()) + " " +
                     std::to_string(mesh.faceCount()) + " " + std::to_string(mesh.edgeCount()) +
                     "\n";
  for (const Vertex v : mesh.vertices()) text += positionText(mesh.position(v));
  for (const Face f : mesh.faces()) {
    text += "3";
    for (const Vertex v : mesh.faceVertices(f)) text += " " + std::to_string(v);
    text += "\n";
  }
  return text;
}

std::string plyFile(const SurfaceMesh& mesh, std::string_view unit) {
  std::string content = "ply\nformat binary_little_endian 1.0\n" + unitComment("comment", unit) +
                        "element vertex " + std::to_string(mesh.vertexCount()) +
                        "\nproperty double x\nproperty double y\nproperty double z\n"
                        "element face " +
                        std::to_string(mesh.faceCount()) +
                        "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vertex v : mesh.vertices()) {
    appendDouble(content, mesh.position(v).x);
    appendDouble(content, mesh.position(v).y);
    appendDouble(content, mesh.position(v).z);
  }
  for (const Face f : mesh.faces()) {
    appendBytes(content, 3, 1);
    for (const Vertex v : mesh.faceVertices(f)) appendBytes(content, v, 4);
  }
  return content;
}

void appendVector(std::string& content, const Vec3& vector) {
  appendFloat(content, nearestFloat(vector.x));
  appendFloat(content, nearestFloat(vector.y));
  appendFloat(content, nearestFloat(vector.z));
}

Vec3 unitNormal(const SurfaceMesh& mesh, Index face) {
  const auto [i, j, k] = mesh.faceVertices(Face(face));
  const Vec3 &a = mesh.position(Vertex(i)), &b = mesh.position(Vertex(j)),
             &c = mesh.position(Vertex(k));
  const Vec3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Vec3 normal{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::hypot(normal.x, normal.y, normal.z);
  // Zero asks readers to compute it themselves.
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {normal.x / length, normal.y / length, normal.z / length};
}

std::string stlFile(const SurfaceMesh& mesh, std::string_view unit) {
  constexpr std::size_t kHeader = 80;
  std::string content = unitHeader(unit);
  content.resize(kHeader, ' ');
  content.reserve(kHeader + 4 + 50 * std::size_t{mesh.faceCount()});
  appendBytes(content, mesh.faceCount(), 4);
  for (const Face f : mesh.faces()) {
    appendVector(content, unitNormal(mesh, f));
    for (const Vertex v : mesh.faceVertices(f)) appendVector(content, mesh.position(v));
    appendBytes(content, 0, 2);
  }
  return content;
}

Result<std::string> glbFile(const SurfaceMesh& mesh, std::string_view unit) {
  GlbWriter writer;
  std::vector<Vec3> positions;
  positions.reserve(mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) positions.push_back(mesh.position(v));
  writer.addPositions(positions);
  writer.addTriangles(mesh);
  writer.endMesh(TINYGLTF_MODE_TRIANGLES, JsonObject().add("unit", unit).text());
  return writer.file(unit);
}

}  // namespace

Result<std::string> meshFile(const SurfaceMesh& mesh, Format format, std::string_view unit) {
  switch (format) {
    case Format::Obj:
      return objFile(mesh, unit);
    case Format::Ply:
      return plyFile(mesh, unit);
    case Format::Stl:
      return stlFile(mesh, unit);
    case Format::Off:
      return offFile(mesh, unit);
    case Format::Glb:
      return glbFile(mesh, unit);
    case Format::Gltf:
      break;
  }
  Error error = makeError(ErrorCode::Usage, -1, "glTF is written as one file only");
  error.hint = "write .glb";
  return error;
}

std::optional<Format> meshFormat(std::string_view ending) {
  if (ending == ".obj") return Format::Obj;
  if (ending == ".ply") return Format::Ply;
  if (ending == ".stl") return Format::Stl;
  if (ending == ".off") return Format::Off;
  if (ending == ".glb") return Format::Glb;
  return std::nullopt;
}

}  // namespace girth::io
