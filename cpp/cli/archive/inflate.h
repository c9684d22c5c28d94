// Deflated data, unpacked within bounds on memory: by zlib, in WebAssembly by the zlib of Node.js.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "girth/error.h"

namespace girth::cli {

/// How many bytes an archive of `packed` bytes may unpack to: 200 times as many, at least 64 MB, at
/// most 1 GB. Models do not shrink to less than a 200th; what does is made to fill the memory.
std::size_t unpackedLimit(std::size_t packed);

/// Whether bytes begin as a gzip file does.
bool isGzip(std::span<const std::byte> bytes);

/// The content of a gzip file, of all its members. Memory: no more than the content. Errors:
/// MALFORMED_FILE where it breaks off or a checksum is wrong; LIMIT_EXCEEDED beyond unpackedLimit.
Result<std::vector<std::byte>> gunzip(std::span<const std::byte> bytes);

/// Raw deflated data that unpack to exactly `size` bytes. Error: MALFORMED_FILE.
Result<std::vector<std::byte>> inflateRaw(std::span<const std::byte> packed, std::size_t size);

/// MALFORMED_FILE: the packed data are wrong; `what` completes "the packed data ...".
Error damagedPack(const std::string& what);

/// LIMIT_EXCEEDED: a file would unpack to more than `limit` bytes.
Error tooLargeUnpacked(std::size_t limit);

/// OUT_OF_MEMORY while a file is unpacked.
Error noMemoryToUnpack();

/// CRC-32 as in zip.
std::uint32_t crc32Of(std::span<const std::byte> bytes);

}  // namespace girth::cli
