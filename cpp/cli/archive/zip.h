// Zip archives: their directory, and their files one at a time. The sizes that an archive states
// are checked before memory is allocated for it. The page reads them alike
// (web/src/kernel/unpack/zip.ts).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "girth/error.h"

namespace girth::cli {

/// A file of an archive, as the archive's directory describes it.
struct ZipEntry {
  /// With '/' between folders, never leading out of the archive.
  std::string path;
  /// Bytes when unpacked.
  std::uint64_t size{0};
  std::uint64_t packedSize{0};
  /// 0: stored, 8: deflated.
  unsigned method{0};
  bool isEncrypted{false};
  std::uint32_t crc{0};
  /// Where the file's own header begins.
  std::uint64_t offset{0};
};

/// Whether bytes begin as a zip archive does.
bool isZip(std::span<const std::byte> bytes);

/// The files of an archive, in the directory's order, without folders, names that are absolute or
/// lead out of the archive, and files that operating systems add. Error: MALFORMED_FILE.
Result<std::vector<ZipEntry>> zipEntries(std::span<const std::byte> archive);

/// The bytes of a file. Errors: LIMIT_EXCEEDED where it is larger than the archive may unpack to;
/// MALFORMED_FILE where size or checksum are not those of the directory; UNSUPPORTED_FEATURE.
Result<std::vector<std::byte>> unzipped(std::span<const std::byte> archive, const ZipEntry& entry);

}  // namespace girth::cli
