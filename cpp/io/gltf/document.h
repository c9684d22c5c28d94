// A glTF document, reduced to its geometry.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"

namespace girth::io {

/// The number of another element. Whoever follows it checks that there is such an element.
using GltfReference = std::optional<std::uint32_t>;

/// The values are those that glTF writes. Int and Double are not glTF, but some write them.
enum class GltfComponent : std::uint16_t {
  Byte = 5120,
  UnsignedByte = 5121,
  Short = 5122,
  UnsignedShort = 5123,
  Int = 5124,
  UnsignedInt = 5125,
  Float = 5126,
  Double = 5130
};

/// Bytes of one component.
std::size_t bytesOf(GltfComponent component);

/// The shape of an accessor's elements. Numbers: how many components there are.
enum class GltfShape : std::uint8_t { Scalar, Vec2, Vec3, Vec4, Mat2, Mat3, Mat4 };

std::string_view toString(GltfShape shape);

enum class GltfMode : std::uint8_t {
  Points,
  Lines,
  LineLoop,
  LineStrip,
  Triangles,
  TriangleStrip,
  TriangleFan
};

/// Where a buffer's bytes are to come from.
struct GltfBuffer {
  /// A data: URI or a relative name; empty: the GLB's binary chunk.
  std::string uri;
  std::uint64_t byteLength{0};
};

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

struct GltfBufferView {
  std::uint32_t buffer{0};
  std::uint64_t byteOffset{0};
  std::uint64_t byteLength{0};
  /// 0: the elements follow each other without a gap.
  std::uint64_t byteStride{0};
  std::optional<GltfMeshopt> packed;
};

struct GltfSparse {
  std::uint64_t count{0};
  std::uint32_t indicesView{0};
  std::uint64_t indicesOffset{0};
  GltfComponent indicesComponent{GltfComponent::UnsignedInt};
  std::uint32_t valuesView{0};
  std::uint64_t valuesOffset{0};
};

struct GltfAccessor {
  /// None: all zero, but for sparse replacements.
  GltfReference bufferView;
  std::uint64_t byteOffset{0};
  std::uint64_t count{0};
  GltfComponent component{GltfComponent::Float};
  GltfShape shape{GltfShape::Scalar};
  bool normalized{false};
  std::optional<GltfSparse> sparse;
};

/// KHR_draco_mesh_compression: the packed mesh, and the numbers by which it knows attributes.
struct GltfDraco {
  std::uint32_t bufferView{0};
  std::optional<std::uint32_t> position;
  /// By set, as in GltfPrimitive.
  std::vector<std::optional<std::uint32_t>> joints;
  std::vector<std::optional<std::uint32_t>> weights;
};

/// The attributes that say where a primitive's points lie.
struct GltfPrimitive {
  GltfMode mode{GltfMode::Triangles};
  GltfReference position;
  GltfReference indices;
  /// JOINTS_0, JOINTS_1, ... and WEIGHTS_0, ...: lists of the same length, up to the last set that
  /// either has.
  std::vector<GltfReference> joints;
  std::vector<GltfReference> weights;
  /// POSITION of each morph target; a target may leave positions alone.
  std::vector<GltfReference> targets;
  std::optional<GltfDraco> draco;
};

struct GltfMesh {
  std::string name;
  std::vector<GltfPrimitive> primitives;
  std::vector<double> weights;
};

/// EXT_mesh_gpu_instancing: accessors of one value an instance.
struct GltfInstancing {
  GltfReference translation;
  GltfReference rotation;
  GltfReference scale;
};

struct GltfNode {
  std::string name;
  std::vector<std::uint32_t> children;
  GltfReference mesh;
  GltfReference skin;
  /// 16 numbers, column by column; else the three after it count. Empty: not given.
  std::vector<double> matrix;
  std::vector<double> translation, rotation, scale;
  std::vector<double> weights;
  std::optional<GltfInstancing> instancing;
  /// KHR_node_visibility: neither the node nor what is below it is shown.
  bool hidden{false};
};

struct GltfSkin {
  std::string name;
  std::vector<std::uint32_t> joints;
  GltfReference inverseBindMatrices;
};

struct GltfScene {
  std::string name;
  std::vector<std::uint32_t> nodes;
};

/// What of a document matters for the surface. Types are right and values are in their ranges, but
/// no number has been checked against another.
struct GltfDocument {
  std::vector<GltfBuffer> buffers;
  std::vector<GltfBufferView> bufferViews;
  std::vector<GltfAccessor> accessors;
  std::vector<GltfMesh> meshes;
  std::vector<GltfNode> nodes;
  std::vector<GltfSkin> skins;
  std::vector<GltfScene> scenes;
  GltfReference scene;
};

/// Parses JSON text that begins at byte `firstByte` of the file. Errors name the place as a JSON
/// pointer, or the byte where the text is no JSON: UNKNOWN_FORMAT (JSON, but not glTF),
/// MALFORMED_FILE, UNSUPPORTED_FEATURE (glTF 1.0, or an extension without which the geometry cannot
/// be read), LIMIT_EXCEEDED.
Result<GltfDocument> parseGltfDocument(std::string_view json, std::size_t firstByte);

/// The first reference in the document that leads nowhere, the first range that does not fit: what
/// to say of a document without triangles, which is most likely broken. Buffers are not fetched.
std::optional<Error> firstFaultOf(const GltfDocument& document);

}  // namespace girth::io
