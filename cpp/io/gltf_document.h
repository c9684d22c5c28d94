// A glTF document, reduced to its geometry.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "tinygltf_header.h"

namespace girth::io {

/// Where a buffer's bytes are to come from.
struct GltfBufferSource {
  /// A data: URI or a relative name; empty: the GLB's binary chunk.
  std::string uri;
  std::uint64_t byteLength{0};
  /// The compression whose unpacked bytes would belong here; such a buffer has none of its own.
  std::string fallbackFor;
};

/// What of a document matters for the surface.
struct GltfDocument {
  /// Accessors, buffer views, meshes, nodes and scenes; of primitives only POSITION, indices and
  /// mode. No number in it has been checked against another.
  tinygltf::Model model;
  std::vector<GltfBufferSource> buffers;
};

/// Parses JSON text. Errors: UNKNOWN_FORMAT (JSON, but not glTF), MALFORMED_FILE,
/// UNSUPPORTED_FEATURE (glTF 1.0, or an extension without which the geometry cannot be read),
/// LIMIT_EXCEEDED.
Result<GltfDocument> parseGltfDocument(std::string_view json);

}  // namespace girth::io
