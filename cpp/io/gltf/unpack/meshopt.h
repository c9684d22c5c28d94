// Buffer views packed with EXT_meshopt_compression or KHR_meshopt_compression.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "girth/error.h"
#include "gltf/document/document.h"
#include "gltf/unpack/soup_budget.h"

namespace girth::io {

/// Unpacks packed.count elements of packed.byteStride bytes. A count that the stream is too short
/// for is refused before any memory is asked for, and the budget pays for the rest. `place` is the
/// extension's JSON pointer. Errors: MALFORMED_FILE, LIMIT_EXCEEDED; UNSUPPORTED_FEATURE in
/// WebAssembly, where the page unpacks before the reader sees a file.
Result<std::vector<std::byte>> unpackMeshopt(const GltfMeshopt& packed,
                                             std::span<const std::byte> bytes, SoupBudget& budget,
                                             const std::string& place);

}  // namespace girth::io
