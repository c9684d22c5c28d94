// glTF 2.0 and GLB to triangles.
#pragma once

#include <cstddef>
#include <span>

#include "girth/io/read_mesh.h"

namespace girth::io {

/// Reads a GLB file: see readModel.
Result<ReadModel> readGlb(std::span<const std::byte> bytes, const ResourceReader& resources,
                          const ReadOptions& options = {});

/// Reads a glTF document in JSON: see readModel.
Result<ReadModel> readGltf(std::span<const std::byte> bytes, const ResourceReader& resources,
                           const ReadOptions& options = {});

}  // namespace girth::io
