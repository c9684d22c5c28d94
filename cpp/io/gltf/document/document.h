// A glTF document: tinygltf's model of its geometry, and how its attributes and extensions are
// understood.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "gltf/document/geometry_json.h"
#include "gltf/document/tinygltf.h"

namespace girth::io {

/// The number of another element. Whoever follows it checks that there is such an element.
using GltfReference = std::optional<std::uint32_t>;

/// A number of the model that was checked to be at least 0.
inline std::uint32_t unsignedOf(int number) { return static_cast<std::uint32_t>(number); }

/// tinygltf writes -1 where there is none.
inline GltfReference referenceOf(int number) {
  return number < 0 ? GltfReference() : GltfReference(static_cast<std::uint32_t>(number));
}

/// Bytes of one component of a type that glTF knows (TINYGLTF_COMPONENT_TYPE_...).
inline std::size_t bytesOf(int componentType) {
  return static_cast<std::size_t>(
      tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(componentType)));
}

/// How many numbers an element of a shape has (TINYGLTF_TYPE_...).
inline std::size_t componentsOf(int shape) {
  return static_cast<std::size_t>(
      tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(shape)));
}

/// A shape as glTF writes it: "VEC3".
std::string_view shapeText(int shape);

/// EXT_meshopt_compression or KHR_meshopt_compression: how a buffer view's bytes are packed.
struct GltfMeshopt {
  enum class Mode : std::uint8_t { Attributes, Triangles, Indices };
  enum class Filter : std::uint8_t { None, Octahedral, Quaternion, Exponential, Color };

  std::string extension;
  std::uint32_t buffer{0};
  std::uint64_t byteOffset{0};
  std::uint64_t byteLength{0};
  std::uint64_t byteStride{0};
  std::uint64_t count{0};
  Mode mode{Mode::Attributes};
  Filter filter{Filter::None};
};

/// How a buffer view is packed, if it is; KHR_meshopt_compression where it has both extensions.
std::optional<GltfMeshopt> meshoptOf(const tinygltf::BufferView& view);

/// Attributes that the surface does not depend on (isExtraAttribute): their accessors, or the
/// numbers by which Draco knows them.
using GltfExtras = std::map<std::string, std::uint32_t>;

/// KHR_draco_mesh_compression: the packed mesh, and the numbers by which it knows attributes.
struct GltfDraco {
  std::uint32_t bufferView{0};
  std::optional<std::uint32_t> position;
  /// By set, as in GltfPrimitive.
  std::vector<std::optional<std::uint32_t>> joints;
  std::vector<std::optional<std::uint32_t>> weights;
  GltfExtras extras;
};

/// The attributes that determine where a primitive's points lie, and those that do not.
struct GltfPrimitive {
  explicit GltfPrimitive(const tinygltf::Primitive& primitive);

  /// TINYGLTF_MODE_...
  int mode;
  GltfReference position;
  GltfReference indices;
  /// JOINTS_0, JOINTS_1, ... and WEIGHTS_0, ...: lists of the same length, up to the last set that
  /// either has.
  std::vector<GltfReference> joints;
  std::vector<GltfReference> weights;
  /// POSITION of each morph target; a target may leave positions alone.
  std::vector<GltfReference> targets;
  std::optional<GltfDraco> draco;
  GltfExtras extras;
  GltfReference material;
};

/// EXT_mesh_gpu_instancing: accessors of one value an instance.
struct GltfInstancing {
  GltfReference translation;
  GltfReference rotation;
  GltfReference scale;
};

/// The instances of a node's mesh, if it has any.
std::optional<GltfInstancing> instancingOf(const tinygltf::Node& node);

/// KHR_node_visibility: whether neither the node nor what is below it is shown.
bool isHidden(const tinygltf::Node& node);

/// The content of a document that matters for the surface. Types are right and values are in their
/// ranges, but no number has been checked against another.
struct GltfDocument {
  /// The whole model; only the buffer of the GLB's binary chunk has its bytes yet.
  tinygltf::Model model;
  std::vector<GltfBufferSource> sources;
  /// By mesh and primitive.
  std::vector<std::vector<GltfPrimitive>> primitives;
  /// By material.
  std::vector<GltfColour> baseColours;
  /// As in GeometryJson.
  bool isUnitUnknown{false};
  std::string leftOut;
};

/// The first reference in the document that leads nowhere, the first range that does not fit: what
/// to report of a document without triangles, which is most likely broken. Buffers are not fetched.
std::optional<Error> firstFaultOf(const GltfDocument& document);

}  // namespace girth::io
