#include "gltf/unpack/draco.h"

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/decoder_buffer.h>
#include <draco/core/varint_decoding.h>
#include <draco/mesh/mesh.h>
#include <draco/metadata/metadata_decoder.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <utility>

#include "gltf/document/fault.h"

namespace girth::io {

struct DracoMesh::Content {
  draco::Mesh mesh;
};

namespace {

draco::DecoderBuffer bufferOf(std::span<const std::byte> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return buffer;
}

/// The claims of a stream before the first number that Draco takes memory for.
struct Claims {
  bool isEdgebreaker{false};
  std::uint64_t faces{0};
  std::uint64_t points{0};
  /// Attributes with seams of their own.
  std::uint64_t seamLists{0};
};

/// Nothing where the stream breaks off or is no mesh.
std::optional<Claims> claimsOf(std::span<const std::byte> bytes, bool& isOtherVersion) {
  isOtherVersion = false;
  draco::DecoderBuffer buffer = bufferOf(bytes);
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) return std::nullopt;
  isOtherVersion = header.version_major != 2 || header.version_minor != 2;
  if (isOtherVersion || header.encoder_type != draco::TRIANGULAR_MESH) return std::nullopt;
  buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(2, 2));
  if ((header.flags & METADATA_FLAG_MASK) != 0) {
    draco::GeometryMetadata metadata;
    draco::MetadataDecoder decoder;
    if (!decoder.DecodeGeometryMetadata(&buffer, &metadata)) return std::nullopt;
  }
  Claims claims;
  claims.isEdgebreaker = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING;
  std::uint32_t faces = 0, points = 0;
  if (!claims.isEdgebreaker) {
    if (!draco::DecodeVarint(&faces, &buffer) || !draco::DecodeVarint(&points, &buffer)) {
      return std::nullopt;
    }
    claims.faces = faces;
    claims.points = points;
    return claims;
  }
  std::uint8_t traversal = 0, seamLists = 0;
  std::uint32_t symbols = 0, splits = 0;
  if (!buffer.Decode(&traversal) || !draco::DecodeVarint(&points, &buffer) ||
      !draco::DecodeVarint(&faces, &buffer) || !buffer.Decode(&seamLists) ||
      !draco::DecodeVarint(&symbols, &buffer) || !draco::DecodeVarint(&splits, &buffer)) {
    return std::nullopt;
  }
  claims.faces = faces;
  claims.points = std::uint64_t{points} + splits;
  claims.seamLists = seamLists;
  return claims;
}

/// A decoder that stops after the last attribute that is wanted, and that asks the budget before it
/// makes room for attributes, whose number and size a stream gives only after its faces.
template <class Decoder>
class Bounded : public Decoder {
 public:
  Bounded(const std::vector<std::uint32_t>& wanted, SoupBudget& budget)
      : wanted_(wanted), budget_(budget) {}

  bool isTooLarge() const { return isTooLarge_; }

 protected:
  bool DecodeAllAttributes() override {
    const int end = wantedDecoders();
    std::uint64_t bytes = 0;
    for (int d = 0; d < end; ++d) {
      for (int a = 0; a < this->attributes_decoder(d)->GetNumAttributes(); ++a) {
        const draco::PointAttribute& attribute = attributeOf(d, a);
        bytes += std::uint64_t{this->point_cloud()->num_points()} * attribute.num_components() *
                 static_cast<std::uint64_t>(draco::DataTypeLength(attribute.data_type()));
      }
    }
    // A point takes about 16 bytes.
    isTooLarge_ = !budget_.take(bytes / 16);
    if (isTooLarge_) return false;
    for (int d = 0; d < end; ++d) {
      // Draco hands out its decoders for reading only, as it runs them itself: all of them.
      auto* decoder = const_cast<draco::AttributesDecoderInterface*>(this->attributes_decoder(d));
      if (!decoder->DecodeAttributes(this->buffer())) return false;
    }
    return true;
  }

 private:
  const draco::PointAttribute& attributeOf(int decoder, int attribute) {
    return *this->point_cloud()->attribute(
        this->attributes_decoder(decoder)->GetAttributeId(attribute));
  }

  /// How many of the decoders, in the stream's order, have to run.
  int wantedDecoders() {
    int end = 0;
    for (int d = 0; d < this->num_attributes_decoders(); ++d) {
      for (int a = 0; a < this->attributes_decoder(d)->GetNumAttributes(); ++a) {
        const std::uint32_t number = attributeOf(d, a).unique_id();
        if (std::find(wanted_.begin(), wanted_.end(), number) != wanted_.end()) end = d + 1;
      }
    }
    return end;
  }

  const std::vector<std::uint32_t>& wanted_;
  SoupBudget& budget_;
  bool isTooLarge_{false};
};

enum class Outcome { Done, Invalid, TooLarge };

template <class Decoder>
Outcome decode(std::span<const std::byte> bytes, const std::vector<std::uint32_t>& wanted,
               SoupBudget& budget, draco::Mesh& mesh) {
  draco::DecoderBuffer buffer = bufferOf(bytes);
  Bounded<Decoder> decoder(wanted, budget);
  const draco::DecoderOptions options;
  try {
    const bool done = decoder.Decode(options, &buffer, &mesh).ok();
    if (decoder.isTooLarge()) return Outcome::TooLarge;
    return done ? Outcome::Done : Outcome::Invalid;
  } catch (const std::length_error&) {
    return Outcome::TooLarge;
  }
}

bool facesAreValid(const draco::Mesh& mesh) {
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f) {
    for (const draco::PointIndex& point : mesh.face(f)) {
      if (point.value() >= mesh.num_points()) return false;
    }
  }
  return true;
}

template <class T>
bool copyAttribute(const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                   std::vector<std::byte>& bytes) {
  const auto components = static_cast<std::size_t>(attribute.num_components());
  const std::size_t elementBytes = components * sizeof(T);
  bytes.resize(mesh.num_points() * elementBytes);
  std::vector<T> element(components);
  for (draco::PointIndex p(0); p < mesh.num_points(); ++p) {
    const draco::AttributeValueIndex value = attribute.mapped_index(p);
    if (value.value() >= attribute.size()) return false;
    if (!attribute.ConvertValue<T>(value, static_cast<std::int8_t>(components), element.data())) {
      return false;
    }
    std::memcpy(bytes.data() + p.value() * elementBytes, element.data(), elementBytes);
  }
  return true;
}

bool copyAttribute(const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                   int componentType, std::vector<std::byte>& bytes) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return copyAttribute<std::int8_t>(mesh, attribute, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copyAttribute<std::uint8_t>(mesh, attribute, bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return copyAttribute<std::int16_t>(mesh, attribute, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copyAttribute<std::uint16_t>(mesh, attribute, bytes);
    case TINYGLTF_COMPONENT_TYPE_INT:
      return copyAttribute<std::int32_t>(mesh, attribute, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copyAttribute<std::uint32_t>(mesh, attribute, bytes);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return copyAttribute<float>(mesh, attribute, bytes);
    default:
      return copyAttribute<double>(mesh, attribute, bytes);
  }
}

}  // namespace

DracoMesh::DracoMesh(std::unique_ptr<Content> content) : content_(std::move(content)) {}
DracoMesh::DracoMesh(DracoMesh&&) noexcept = default;
DracoMesh& DracoMesh::operator=(DracoMesh&&) noexcept = default;
DracoMesh::~DracoMesh() = default;

Result<DracoMesh> DracoMesh::unpack(std::span<const std::byte> bytes,
                                    const std::vector<std::uint32_t>& numbers, SoupBudget& budget,
                                    const std::string& place) {
  bool isOtherVersion = false;
  const auto claims = claimsOf(bytes, isOtherVersion);
  if (isOtherVersion) {
    return makeError(ErrorCode::UnsupportedFeature, -1,
                     place + ": its Draco stream is not of version 2.2, which glTF prescribes");
  }
  if (!claims) return faultAt(place, "its Draco stream is not valid");
  // Half a bit a face would be more regular than anything real.
  constexpr std::uint64_t kMostFacesPerByte = 16;
  budget.allowFor(kMostFacesPerByte * bytes.size());
  const auto tooLarge = [&] {
    return makeError(ErrorCode::LimitExceeded, -1,
                     place + ": its Draco stream claims " + std::to_string(claims->faces) +
                         " faces, far more than fit into its " + std::to_string(bytes.size()) +
                         " bytes");
  };
  if (!budget.take(claims->points + 3 * claims->faces * (1 + claims->seamLists))) return tooLarge();

  auto content = std::make_unique<Content>();
  const Outcome outcome =
      claims->isEdgebreaker
          ? decode<draco::MeshEdgebreakerDecoder>(bytes, numbers, budget, content->mesh)
          : decode<draco::MeshSequentialDecoder>(bytes, numbers, budget, content->mesh);
  if (outcome == Outcome::TooLarge) return tooLarge();
  if (outcome == Outcome::Invalid || !facesAreValid(content->mesh)) {
    return faultAt(place, "its Draco stream is not valid");
  }
  return DracoMesh(std::move(content));
}

std::size_t DracoMesh::pointCount() const { return content_->mesh.num_points(); }

std::size_t DracoMesh::faceCount() const { return content_->mesh.num_faces(); }

void DracoMesh::appendFaces(std::vector<Index>& corners) const {
  corners.reserve(corners.size() + 3 * faceCount());
  for (draco::FaceIndex f(0); f < content_->mesh.num_faces(); ++f) {
    for (const draco::PointIndex& point : content_->mesh.face(f)) corners.push_back(point.value());
  }
}

std::optional<std::vector<std::byte>> DracoMesh::attribute(std::uint32_t number,
                                                           std::size_t components,
                                                           int componentType) const {
  const draco::PointAttribute* found = content_->mesh.GetAttributeByUniqueId(number);
  if (found == nullptr || static_cast<std::size_t>(found->num_components()) != components) {
    return std::nullopt;
  }
  std::vector<std::byte> bytes;
  if (!copyAttribute(content_->mesh, *found, componentType, bytes)) return std::nullopt;
  return bytes;
}

}  // namespace girth::io
