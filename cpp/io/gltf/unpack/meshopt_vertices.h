// The second version of meshoptimizer's vertex streams, which KHR_meshopt_compression added and
// which Debian's meshoptimizer (0.18) does not know.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace girth::io {

bool isMeshoptVertexVersion1(std::span<const std::byte> bytes);

/// The fewest bytes that a vertex stream of either version can have; whether the bytes are the
/// second's is looked up in them.
std::uint64_t leastMeshoptVertexBytes(std::uint64_t count, std::uint64_t stride,
                                      std::span<const std::byte> bytes);

/// Decodes `count` vertices of `stride` bytes (4 to 256, a multiple of 4) into `vertices`, which
/// has room for them. False where the stream is not valid; it is never read beyond its end.
/// Source: KHR_meshopt_compression, appendix A, mode 0.
bool decodeMeshoptVertexVersion1(std::vector<std::byte>& vertices, std::size_t count,
                                 std::size_t stride, std::span<const std::byte> bytes);

}  // namespace girth::io
