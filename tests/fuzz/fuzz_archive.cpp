// Any bytes as a gzip file or a zip, unpacked as the command does.
#include <algorithm>

#include "archive/inflate.h"
#include "archive/zip.h"
#include "checks.h"

namespace {

/// Unpacked content is within the bound on memory; every failure is a coded error.
void checkContent(const girth::Result<std::vector<std::byte>>& content, std::size_t packed) {
  if (!content) return girth::fuzz::check(content.error());
  girth::fuzz::demand(content.value().size() <= girth::cli::unpackedLimit(packed),
                      "no more is unpacked than is allowed");
}

/// No part of the path leads out of the archive.
bool staysInside(const std::string& path) {
  return !path.empty() && path.front() != '/' && path.find('\\') == std::string::npos &&
         ("/" + path + "/").find("/../") == std::string::npos;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace girth;
  const auto bytes = fuzz::bytesOf(data, size);
  if (cli::isGzip(bytes)) checkContent(cli::gunzip(bytes), size);
  if (!cli::isZip(bytes)) return 0;
  const auto entries = cli::zipEntries(bytes);
  if (!entries) {
    fuzz::check(entries.error());
    return 0;
  }
  for (const cli::ZipEntry& entry : entries.value()) {
    fuzz::demand(staysInside(entry.path), "paths stay inside: " + entry.path);
  }
  // Entries may overlap; a few of them show what unpacking one does.
  constexpr std::size_t kTried = 8;
  for (std::size_t i = 0; i < std::min(kTried, entries.value().size()); ++i) {
    checkContent(cli::unzipped(bytes, entries.value()[i]), size);
  }
  return 0;
}
