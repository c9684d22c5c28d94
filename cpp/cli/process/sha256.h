// SHA-256 (FIPS 180-4): identifies contents, and detects damaged ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace girth::cli {

using Digest = std::array<std::uint8_t, 32>;

class Sha256 {
 public:
  Sha256& add(std::span<const std::byte> bytes);
  Sha256& add(std::string_view text) {
    return add(std::as_bytes(std::span(text.data(), text.size())));
  }
  /// The digest of all that was added; nothing may be added afterwards.
  Digest finish();

 private:
  void addBlock();

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> block_{};
  std::size_t filled_{0};
  std::uint64_t bytes_{0};
};

/// 64 hexadecimal digits.
std::string hexText(const Digest& digest);

}  // namespace girth::cli
