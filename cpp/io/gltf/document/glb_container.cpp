#include "gltf/document/glb_container.h"

#include <cstdint>
#include <string>

#include "malformed.h"

namespace girth::io {
namespace {

constexpr std::uint32_t kMark = 0x46546C67;       // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

std::uint32_t littleEndian32(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
  }
  return value;
}

}  // namespace

bool hasGlbMark(std::span<const std::byte> bytes) {
  return bytes.size() >= 4 && littleEndian32(bytes, 0) == kMark;
}

Result<GlbContainer> openGlb(std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderBytes) {
    return malformed(bytes.size(),
                     "the GLB header breaks off at byte " + std::to_string(bytes.size()));
  }
  if (!hasGlbMark(bytes)) return malformed(0, "the file does not begin with \"glTF\"");
  const std::uint32_t version = littleEndian32(bytes, 4);
  if (version != 2) {
    return makeError(ErrorCode::UnsupportedFeature, 4,
                     "this is GLB version " + std::to_string(version) + "; only version 2 is read");
  }
  const std::size_t length = littleEndian32(bytes, 8);
  if (length > bytes.size()) {
    return malformed(bytes.size(), "the file breaks off: its header promises " +
                                       std::to_string(length) + " bytes, but there are " +
                                       std::to_string(bytes.size()));
  }

  GlbContainer container;
  bool jsonSeen = false;
  bool binarySeen = false;
  std::size_t at = kHeaderBytes;
  while (at < length) {
    if (length - at < kChunkHeaderBytes) {
      // Padding after the last chunk does no harm.
      if (jsonSeen) break;
      return malformed(at, "the GLB has no JSON chunk");
    }
    const std::size_t chunkLength = littleEndian32(bytes, at);
    const std::uint32_t type = littleEndian32(bytes, at + 4);
    const std::size_t begin = at + kChunkHeaderBytes;
    if (chunkLength > length - begin) {
      return malformed(at, "the GLB chunk at byte " + std::to_string(at) + " claims " +
                               std::to_string(chunkLength) + " bytes, but " +
                               std::to_string(length - begin) + " are left");
    }
    const auto content = bytes.subspan(begin, chunkLength);
    if (!jsonSeen) {
      if (type != kJsonChunk) return malformed(at, "the first GLB chunk is not JSON");
      container.json = {reinterpret_cast<const char*>(content.data()), content.size()};
      jsonSeen = true;
    } else if (type == kBinaryChunk && !binarySeen) {
      container.binary = content;
      binarySeen = true;
    }
    at = begin + chunkLength;
  }
  if (!jsonSeen) return malformed(kHeaderBytes, "the GLB has no JSON chunk");
  return container;
}

}  // namespace girth::io
