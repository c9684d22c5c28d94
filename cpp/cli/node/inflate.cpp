#include "archive/inflate.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include "node/node.h"

namespace girth::cli {
namespace {

struct Free {
  void operator()(void* memory) const { std::free(memory); }
};

Result<std::vector<std::byte>> inflated(std::span<const std::byte> packed, std::size_t limit,
                                        bool isRaw, const Error& tooLarge) {
  void* made = nullptr;
  const int length = girthInflate(packed.data(), packed.size(), std::max<std::size_t>(1, limit),
                                  isRaw ? 1 : 0, &made);
  const std::unique_ptr<void, Free> memory(made);
  if (length == kDamaged) return damagedPack("are not what was packed");
  if (length == kBreaksOff) return damagedPack("break off");
  if (length == kTooLarge) return tooLarge;
  if (length < 0) return noMemoryToUnpack();
  const auto* content = static_cast<const std::byte*>(made);
  return std::vector<std::byte>(content, content + length);
}

/// The table of CRC-32: what each byte makes of the remainder.
constexpr std::array<std::uint32_t, 256> kRemainders = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder >> 1) ^ ((remainder & 1) != 0 ? 0xEDB88320u : 0u);
    }
    table[byte] = remainder;
  }
  return table;
}();

}  // namespace

Result<std::vector<std::byte>> gunzip(std::span<const std::byte> bytes) {
  const std::size_t limit = unpackedLimit(bytes.size());
  return inflated(bytes, limit, false, tooLargeUnpacked(limit));
}

Result<std::vector<std::byte>> inflateRaw(std::span<const std::byte> packed, std::size_t size) {
  const Error larger = damagedPack("are larger than they claim");
  auto content = inflated(packed, size, true, larger);
  if (!content) return content;
  if (content.value().size() > size) return larger;
  if (content.value().size() < size) return damagedPack("are smaller than they claim");
  return content;
}

std::uint32_t crc32Of(std::span<const std::byte> bytes) {
  std::uint32_t remainder = 0xFFFFFFFFu;
  for (const std::byte byte : bytes) {
    remainder =
        (remainder >> 8) ^ kRemainders[(remainder ^ static_cast<std::uint32_t>(byte)) & 0xFF];
  }
  return ~remainder;
}

}  // namespace girth::cli
