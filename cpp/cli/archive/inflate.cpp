#include "archive/inflate.h"

#include <algorithm>

namespace girth::cli {
namespace {

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

}  // namespace

std::size_t unpackedLimit(std::size_t packed) {
  return std::min(1024 * kMegabyte, std::max(64 * kMegabyte, 200 * packed));
}

bool isGzip(std::span<const std::byte> bytes) {
  return bytes.size() >= 2 && bytes[0] == std::byte{0x1f} && bytes[1] == std::byte{0x8b};
}

Error damagedPack(const std::string& what) {
  Error error = makeError(ErrorCode::MalformedFile, -1, "the packed data " + what);
  error.hint = "pack the model again, or send it unpacked";
  return error;
}

Error tooLargeUnpacked(std::size_t limit) {
  Error error =
      makeError(ErrorCode::LimitExceeded, -1,
                "it would unpack to more than " + std::to_string(limit / kMegabyte) + " MB");
  error.hint = "unpack it yourself, if you trust it";
  return error;
}

Error noMemoryToUnpack() {
  return makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory to unpack the file");
}

}  // namespace girth::cli
