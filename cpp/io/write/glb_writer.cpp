#include "write/glb_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "bytes/append.h"
#include "girth/io/length_unit.h"
#include "gltf/document/tinygltf_model.h"

namespace girth::io {
namespace {

constexpr int kVertices = TINYGLTF_TARGET_ARRAY_BUFFER;
constexpr int kIndices = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;

/// The least and the greatest of each of some components, as glTF wants them of floats.
class Bounds {
 public:
  explicit Bounds(std::size_t components)
      : low_(components, std::numeric_limits<float>::max()),
        high_(components, std::numeric_limits<float>::lowest()) {}

  void take(std::size_t component, float value) {
    low_[component] = std::min(low_[component], value);
    high_[component] = std::max(high_[component], value);
  }
  void write(tinygltf::Accessor& accessor) const {
    accessor.minValues.assign(low_.begin(), low_.end());
    accessor.maxValues.assign(high_.begin(), high_.end());
  }

 private:
  std::vector<float> low_, high_;
};

}  // namespace

GlbWriter::GlbWriter() { model_.buffers.resize(1); }

int GlbWriter::addAccessor(std::size_t begin, std::size_t count, int type, int componentType,
                           int target) {
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = begin;
  view.byteLength = bytes().size() - begin;
  view.target = target;
  model_.bufferViews.push_back(view);
  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(model_.bufferViews.size() - 1);
  accessor.componentType = componentType;
  accessor.type = type;
  accessor.count = count;
  model_.accessors.push_back(accessor);
  return static_cast<int>(model_.accessors.size() - 1);
}

void GlbWriter::addPositions(std::span<const Vec3> positions) {
  const std::size_t begin = bytes().size();
  Bounds bounds(3);
  for (const Vec3& position : positions) {
    const std::array<double, 3> coordinates{position.x, position.y, position.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const float coordinate = nearestFloat(coordinates[k]);
      appendFloat(bytes(), coordinate);
      bounds.take(k, coordinate);
    }
  }
  primitive_.attributes["POSITION"] = addAccessor(begin, positions.size(), TINYGLTF_TYPE_VEC3,
                                                  TINYGLTF_COMPONENT_TYPE_FLOAT, kVertices);
  bounds.write(model_.accessors.back());
}

void GlbWriter::addValues(const std::string& attribute, std::span<const double> values,
                          Index width) {
  constexpr std::array kTypes{TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3,
                              TINYGLTF_TYPE_VEC4};
  const std::size_t begin = bytes().size();
  Bounds bounds(width);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float number = std::isnan(values[i]) ? -1 : nearestFloat(values[i]);
    appendFloat(bytes(), number);
    bounds.take(i % width, number);
  }
  primitive_.attributes[attribute] = addAccessor(begin, values.size() / width, kTypes[width - 1],
                                                 TINYGLTF_COMPONENT_TYPE_FLOAT, kVertices);
  bounds.write(model_.accessors.back());
}

void GlbWriter::addColours(std::span<const std::uint16_t> channels) {
  const std::size_t begin = bytes().size();
  for (const std::uint16_t channel : channels) appendBytes(bytes(), channel, 2);
  primitive_.attributes["COLOR_0"] = addAccessor(begin, channels.size() / 4, TINYGLTF_TYPE_VEC4,
                                                 TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, kVertices);
  model_.accessors.back().normalized = true;
  showColours();
}

void GlbWriter::addColours(std::span<const double> channels) {
  addValues("COLOR_0", channels, 4);
  showColours();
}

void GlbWriter::showColours() {
  tinygltf::Material material;
  material.doubleSided = true;
  material.pbrMetallicRoughness.metallicFactor = 0;
  model_.materials.assign(1, material);
  primitive_.material = 0;
}

void GlbWriter::addTriangles(const SurfaceMesh& mesh) {
  std::vector<Index> triangles;
  triangles.reserve(mesh.halfedgeCount());
  for (const Halfedge h : mesh.halfedges()) triangles.push_back(mesh.from(h));
  addTriangles(triangles);
}

void GlbWriter::addTriangles(std::span<const Index> triangles) {
  const std::size_t begin = bytes().size();
  for (const Index vertex : triangles) appendBytes(bytes(), vertex, 4);
  primitive_.indices = addAccessor(begin, triangles.size(), TINYGLTF_TYPE_SCALAR,
                                   TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, kIndices);
}

void GlbWriter::endMesh(int mode, const std::string& extras, const std::string& name) {
  primitive_.mode = mode;
  tinygltf::Node node;
  node.name = name;
  node.mesh = static_cast<int>(model_.meshes.size());
  tinygltf::Mesh mesh;
  mesh.primitives.push_back(std::move(primitive_));
  mesh.extras = valueOf(extras);
  model_.meshes.push_back(std::move(mesh));
  model_.nodes.push_back(std::move(node));
  primitive_ = {};
}

Result<std::string> GlbWriter::file(std::string_view unit) {
  if (bytes().empty()) model_.buffers.clear();
  const LengthUnit* known = findLengthUnit(unit);
  model_.scenes.resize(1);
  for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
    if (known != nullptr && known->metres != 1) model_.nodes[i].scale.assign(3, known->metres);
    model_.scenes[0].nodes.push_back(static_cast<int>(i));
  }
  model_.defaultScene = 0;
  model_.asset.generator = "Girth";
  return glbOf(model_);
}

void addLine(const LoadedMesh& loaded, const std::vector<SurfacePoint>& points,
             const std::string& extras, const std::string& name, GlbWriter& writer) {
  std::vector<Vec3> places;
  places.reserve(points.size());
  for (const SurfacePoint& point : points) places.push_back(positionOf(loaded.mesh, point));
  writer.addPositions(places);
  writer.endMesh(TINYGLTF_MODE_LINE_STRIP, extras, name);
}

}  // namespace girth::io
