#include "picture/png.h"

#include <algorithm>
#include <array>
#include <vector>

namespace girth::io {
namespace {

/// Bits from the lowest on, as RFC 1951 packs them.
class BitWriter {
 public:
  void put(std::uint32_t bits, unsigned count) {
    held_ |= std::uint64_t{bits} << heldCount_;
    heldCount_ += count;
    for (; heldCount_ >= 8; heldCount_ -= 8, held_ >>= 8) bytes_ += static_cast<char>(held_ & 0xFF);
  }
  /// A Huffman code, whose highest bit comes first.
  void putCode(std::uint32_t code, unsigned count) {
    for (unsigned i = count; i > 0; --i) put(code >> (i - 1) & 1, 1);
  }
  std::string finish() {
    if (heldCount_ > 0) put(0, 8 - heldCount_);
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
  std::uint64_t held_{0};
  unsigned heldCount_{0};
};

/// The fixed code of a literal or length symbol.
void putSymbol(BitWriter& out, std::uint32_t symbol) {
  if (symbol < 144) {
    out.putCode(0x30 + symbol, 8);
  } else if (symbol < 256) {
    out.putCode(0x190 + symbol - 144, 9);
  } else if (symbol < 280) {
    out.putCode(symbol - 256, 7);
  } else {
    out.putCode(0xC0 + symbol - 280, 8);
  }
}

constexpr std::array<std::uint16_t, 29> kLengthBase{3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                                    15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                                    67, 83, 99, 115, 131, 163, 195, 227, 258};
constexpr std::array<std::uint8_t, 29> kLengthBits{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                                   2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
constexpr std::array<std::uint16_t, 30> kDistanceBase{
    1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
    193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};

void putMatch(BitWriter& out, std::size_t length, std::size_t distance) {
  const auto l = static_cast<std::size_t>(
      std::upper_bound(kLengthBase.begin(), kLengthBase.end(), length) - kLengthBase.begin() - 1);
  putSymbol(out, static_cast<std::uint32_t>(257 + l));
  out.put(static_cast<std::uint32_t>(length - kLengthBase[l]), kLengthBits[l]);
  const auto d = static_cast<std::size_t>(
      std::upper_bound(kDistanceBase.begin(), kDistanceBase.end(), distance) -
      kDistanceBase.begin() - 1);
  out.putCode(static_cast<std::uint32_t>(d), 5);
  out.put(static_cast<std::uint32_t>(distance - kDistanceBase[d]),
          d < 2 ? 0 : static_cast<unsigned>(d / 2 - 1));
}

/// The zlib stream (RFC 1950): of each three bytes the last place where they stood before is tried.
std::string deflated(const std::string& text) {
  constexpr std::size_t kWindow = 32768, kLongest = 258, kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> last(std::size_t{1} << 15, kNone);
  BitWriter out;
  out.put(0x78, 8);
  out.put(0x01, 8);
  out.put(3, 3);  // the last block, fixed codes
  const auto byteAt = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  for (std::size_t at = 0; at < text.size();) {
    std::size_t length = 0, before = kNone;
    if (at + 3 <= text.size()) {
      const std::uint32_t three = byteAt(at) | static_cast<std::uint32_t>(byteAt(at + 1)) << 8 |
                                  static_cast<std::uint32_t>(byteAt(at + 2)) << 16;
      std::size_t& place = last[(three * 2654435761u) >> 17];
      before = place;
      place = at;
      if (before != kNone && at - before <= kWindow) {
        const std::size_t most = std::min(kLongest, text.size() - at);
        while (length < most && text[before + length] == text[at + length]) ++length;
      }
    }
    if (length >= 3) {
      putMatch(out, length, at - before);
      at += length;
    } else {
      putSymbol(out, byteAt(at));
      ++at;
    }
  }
  putSymbol(out, 256);
  std::string stream = out.finish();
  std::uint32_t a = 1, b = 0;
  for (const char c : text) {
    a = (a + static_cast<std::uint8_t>(c)) % 65521;
    b = (b + a) % 65521;
  }
  for (const std::uint32_t byte : {b >> 8, b & 0xFF, a >> 8, a & 0xFF}) {
    stream += static_cast<char>(byte);
  }
  return stream;
}

std::string bigEndian(std::uint32_t value) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 0xFF);
  return text;
}

std::string chunk(const std::string& type, const std::string& content) {
  const std::string body = type + content;
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : body) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
  }
  return bigEndian(static_cast<std::uint32_t>(content.size())) + body + bigEndian(~crc);
}

}  // namespace

std::string greyPng(std::span<const std::uint8_t> pixels, std::uint32_t width, std::uint32_t height,
                    unsigned channels) {
  const std::size_t row = std::size_t{width} * channels;
  std::string rows;
  for (std::uint32_t y = 0; y < height; ++y) {
    rows += '\0';  // no filter
    rows.append(reinterpret_cast<const char*>(pixels.data()) + y * row, row);
  }
  std::string header = bigEndian(width) + bigEndian(height);
  header += static_cast<char>(8);
  header += static_cast<char>(channels == 2 ? 4 : 0);
  header += std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", deflated(rows)) +
         chunk("IEND", "");
}

}  // namespace girth::io
