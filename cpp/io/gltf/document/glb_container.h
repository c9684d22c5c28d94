// The GLB container: a header and chunks around a glTF document and its bytes.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "girth/error.h"

namespace girth::io {

/// The parts of a GLB file; both refer to the file's own bytes.
struct GlbContainer {
  std::string_view json;
  /// The binary chunk; empty where there is none.
  std::span<const std::byte> binary;
};

/// Whether the bytes begin with GLB's mark.
bool hasGlbMark(std::span<const std::byte> bytes);

/// Checks the header and every chunk's length. Errors: MALFORMED_FILE (byte), UNSUPPORTED_FEATURE.
Result<GlbContainer> openGlb(std::span<const std::byte> bytes);

}  // namespace girth::io
