#include "file_content.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <numeric>
#include <string>
#include <utility>

#include "boundary.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// All numbers of each corner, side by side; NaN bits as they are.
struct Rows {
  std::size_t width{0};
  std::vector<double> values;

  const double* of(Index corner) const { return values.data() + corner * width; }
  int compare(Index one, Index other) const {
    return std::memcmp(of(one), of(other), width * sizeof(double));
  }
};

Rows rowsOf(const std::vector<io::Attribute>& attributes, std::size_t corners) {
  Rows rows;
  for (const io::Attribute& attribute : attributes) rows.width += attribute.width;
  rows.values.resize(corners * rows.width);
  std::size_t begin = 0;
  for (const io::Attribute& attribute : attributes) {
    for (std::size_t corner = 0; corner < corners; ++corner) {
      std::copy_n(attribute.values.data() + corner * attribute.width, attribute.width,
                  rows.values.data() + corner * rows.width + begin);
    }
    begin += attribute.width;
  }
  return rows;
}

/// The surface's corners, those at one vertex together.
std::vector<Index> cornersByVertex(const SurfaceMesh& mesh) {
  std::vector<Index> first(std::size_t{mesh.vertexCount()} + 1, 0);
  for (const Halfedge h : mesh.halfedges()) ++first[mesh.from(h) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Index> corners(mesh.halfedgeCount());
  for (const Halfedge h : mesh.halfedges()) corners[first[mesh.from(h)]++] = h;
  return corners;
}

}  // namespace

val fileContentOf(const PreparedSurface& surface, const std::vector<io::Attribute>& corners) {
  const SurfaceMesh& mesh = surface.mesh;
  val attributes = val::array();
  for (const io::Attribute& attribute : corners) {
    val entry = val::object();
    entry.set("name", attribute.name);
    entry.set("width", attribute.width);
    entry.set("isLinear", attribute.isLinear);
    attributes.call<void>("push", entry);
  }
  std::vector<Index> rowOfCorner;
  std::vector<double> values;
  if (!corners.empty()) {
    const Rows rows = rowsOf(corners, mesh.halfedgeCount());
    std::vector<Index> order = cornersByVertex(mesh);
    rowOfCorner.resize(order.size());
    Index row = 0;
    for (std::size_t begin = 0; begin < order.size();) {
      std::size_t end = begin;
      const Vertex v = mesh.from(Halfedge(order[begin]));
      while (end < order.size() && mesh.from(Halfedge(order[end])) == v) ++end;
      std::sort(order.begin() + static_cast<std::ptrdiff_t>(begin),
                order.begin() + static_cast<std::ptrdiff_t>(end),
                [&](Index a, Index b) { return rows.compare(a, b) < 0; });
      for (std::size_t i = begin; i < end; ++i) {
        if (i == begin || rows.compare(order[i - 1], order[i]) != 0) {
          values.insert(values.end(), rows.of(order[i]), rows.of(order[i]) + rows.width);
          ++row;
        }
        rowOfCorner[order[i]] = row - 1;
      }
      begin = end;
    }
  }
  val result = val::object();
  result.set("faceCount", surface.report.inputFaces);
  result.set("inputOfFace", copyOut<Index>("Uint32Array", surface.inputOfFace));
  result.set("attributes", attributes);
  result.set("rowOfCorner", copyOut<Index>("Uint32Array", rowOfCorner));
  result.set("values", copyOut<double>("Float64Array", values));
  return result;
}

WithFileContent::WithFileContent(io::LoadedMesh& loaded, const val& content) : loaded_(loaded) {
  loaded.report.inputFaces = content["faceCount"].as<Index>();
  loaded.inputOfFace = copyIn<Index>(content["inputOfFace"]);
  const auto rowOfCorner = copyIn<Index>(content["rowOfCorner"]);
  const auto values = copyIn<double>(content["values"]);
  const val attributes = content["attributes"];
  const auto count = attributes["length"].as<unsigned>();
  std::size_t width = 0;
  for (unsigned i = 0; i < count; ++i) width += attributes[i]["width"].as<Index>();
  std::size_t begin = 0;
  std::vector<io::Attribute> kept;
  for (unsigned i = 0; i < count; ++i) {
    const val entry = attributes[i];
    io::Attribute attribute{entry["name"].as<std::string>(),
                            entry["width"].as<Index>(),
                            entry["isLinear"].as<bool>(),
                            {}};
    attribute.values.reserve(rowOfCorner.size() * attribute.width);
    for (const Index row : rowOfCorner) {
      const double* first = values.data() + row * width + begin;
      attribute.values.insert(attribute.values.end(), first, first + attribute.width);
    }
    begin += attribute.width;
    kept.push_back(std::move(attribute));
  }
  loaded.attributes = std::move(kept);
}

WithFileContent::~WithFileContent() {
  loaded_.report.inputFaces = 0;
  loaded_.inputOfFace = {};
  loaded_.attributes = {};
}

}  // namespace girth::bind
