#include "gltf/unpack/meshopt_vertices.h"

#include <algorithm>
#include <array>

namespace girth::io {
namespace {

constexpr unsigned kVersion1 = 0xA1;
constexpr std::size_t kGroup = 16;         // bytes that share one header entry
constexpr std::size_t kMostInBlock = 256;  // vertices
constexpr std::size_t kBlockBytes = 8192;
constexpr std::size_t kLeastTail = 24;   // bytes, of version 1
constexpr std::size_t kLeastTail0 = 32;  // bytes, of version 0

std::size_t blockSize(std::size_t stride) {
  return std::min(kBlockBytes / stride / kGroup * kGroup, kMostInBlock);
}

std::size_t headerBytes(std::size_t vertices) {
  const std::size_t groups = (vertices + kGroup - 1) / kGroup;
  return (groups + 3) / 4;
}

unsigned byteAt(std::span<const std::byte> bytes, std::size_t at) {
  return std::to_integer<unsigned>(bytes[at]);
}

/// Reads a stream from its front, never beyond its end.
class Front {
 public:
  explicit Front(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size(); }
  /// Whether there were so many bytes; they come back in `taken`.
  bool take(std::size_t count, std::span<const std::byte>& taken) {
    if (count > bytes_.size()) return false;
    taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return true;
  }

 private:
  std::span<const std::byte> bytes_;
};

using Deltas = std::array<std::uint8_t, kMostInBlock>;

/// A group of 16 differences of `bits` bits each. One with all bits set stands for a whole byte,
/// which follows after the group.
bool decodeGroup(Front& front, unsigned bits, std::uint8_t* deltas) {
  std::span<const std::byte> coded;
  if (!front.take(kGroup * bits / 8, coded)) return false;
  for (std::size_t i = 0; i < kGroup; ++i) {
    if (bits == 0) {
      deltas[i] = 0;
    } else if (bits == 8) {
      deltas[i] = static_cast<std::uint8_t>(byteAt(coded, i));
    } else {
      const std::size_t perByte = 8 / bits;
      const std::size_t within = i % perByte;
      // Single bits begin with the lowest of a byte, wider ones with the highest.
      const std::size_t shift = bits == 1 ? within : 8 - bits * (within + 1);
      const unsigned mask = (1u << bits) - 1;
      unsigned value = byteAt(coded, i / perByte) >> shift & mask;
      if (value == mask) {
        std::span<const std::byte> whole;
        if (!front.take(1, whole)) return false;
        value = byteAt(whole, 0);
      }
      deltas[i] = static_cast<std::uint8_t>(value);
    }
  }
  return true;
}

/// The differences of one byte of all vertices of a block.
bool decodeByte(Front& front, unsigned control, std::size_t vertices, Deltas& deltas) {
  // The meaning of the two bits of a group's header, for either control.
  constexpr unsigned kBits[2][4] = {{0, 1, 2, 4}, {1, 2, 4, 8}};
  if (control == 2) {
    deltas.fill(0);
    return true;
  }
  if (control == 3) {
    std::span<const std::byte> plain;
    if (!front.take(vertices, plain)) return false;
    for (std::size_t i = 0; i < vertices; ++i) {
      deltas[i] = static_cast<std::uint8_t>(byteAt(plain, i));
    }
    return true;
  }
  std::span<const std::byte> header;
  if (!front.take(headerBytes(vertices), header)) return false;
  for (std::size_t group = 0; group * kGroup < vertices; ++group) {
    const unsigned mode = byteAt(header, group / 4) >> (group % 4 * 2) & 3u;
    if (!decodeGroup(front, kBits[control][mode], deltas.data() + group * kGroup)) return false;
  }
  return true;
}

/// A number whose lowest bit is its sign.
std::uint32_t unzigzag(std::uint32_t value) { return (value >> 1) ^ (0u - (value & 1u)); }

/// Adds the differences of four bytes to those of the vertex before. `channel` determines how the
/// four are coupled: as bytes, as two numbers of 16 bits, or as one of 32 that is turned and XORed.
void addDeltas(unsigned channel, const std::array<std::uint8_t, 4>& deltas, std::uint8_t* last) {
  const auto pair = [](const std::uint8_t* at) {
    return static_cast<std::uint32_t>(at[0] | at[1] << 8);
  };
  switch (channel & 3u) {
    case 0:
      for (std::size_t k = 0; k < 4; ++k) {
        last[k] = static_cast<std::uint8_t>(last[k] + unzigzag(deltas[k]));
      }
      break;
    case 1:
      for (std::size_t k = 0; k < 4; k += 2) {
        const std::uint32_t sum = pair(last + k) + unzigzag(pair(deltas.data() + k));
        last[k] = static_cast<std::uint8_t>(sum);
        last[k + 1] = static_cast<std::uint8_t>(sum >> 8);
      }
      break;
    default: {
      const std::uint32_t delta = pair(deltas.data()) | pair(deltas.data() + 2) << 16;
      const unsigned turn = channel >> 4;
      const std::uint32_t turned = turn == 0 ? delta : delta >> turn | delta << (32 - turn);
      for (std::size_t k = 0; k < 4; ++k) {
        last[k] = static_cast<std::uint8_t>(last[k] ^ (turned >> (8 * k)));
      }
    }
  }
}

}  // namespace

bool isMeshoptVertexVersion1(std::span<const std::byte> bytes) {
  return !bytes.empty() && byteAt(bytes, 0) == kVersion1;
}

std::uint64_t leastMeshoptVertexBytes(std::uint64_t count, std::uint64_t stride,
                                      std::span<const std::byte> bytes) {
  const std::size_t block = blockSize(static_cast<std::size_t>(stride));
  const std::uint64_t blocks = count / block + (count % block == 0 ? 0 : 1);
  if (!isMeshoptVertexVersion1(bytes)) {
    // A header of two bits for every 16 bytes, also where all are zero.
    const std::uint64_t whole = count / block * headerBytes(block);
    const std::uint64_t rest = headerBytes(static_cast<std::size_t>(count % block));
    return 1 + (whole + rest) * stride + std::max<std::uint64_t>(stride, kLeastTail0);
  }
  return 1 + blocks * (stride / 4) + std::max<std::uint64_t>(stride + stride / 4, kLeastTail);
}

bool decodeMeshoptVertexVersion1(std::vector<std::byte>& vertices, std::size_t count,
                                 std::size_t stride, std::span<const std::byte> bytes) {
  const std::size_t tailBytes = stride + stride / 4;
  const std::size_t tailRoom = std::max(tailBytes, kLeastTail);
  if (!isMeshoptVertexVersion1(bytes) || bytes.size() < 1 + tailRoom) return false;
  const auto tail = bytes.last(tailBytes);
  const auto channels = tail.subspan(stride);
  std::array<std::uint8_t, 256> last{};
  for (std::size_t k = 0; k < stride; ++k) last[k] = static_cast<std::uint8_t>(byteAt(tail, k));
  for (std::size_t k = 0; k < stride / 4; ++k) {
    if ((byteAt(channels, k) & 3u) == 3) return false;
  }

  Front front(bytes.subspan(1, bytes.size() - 1 - tailRoom));
  std::array<Deltas, 4> deltas;
  const std::size_t block = blockSize(stride);
  for (std::size_t first = 0; first < count; first += block) {
    const std::size_t size = std::min(block, count - first);
    std::span<const std::byte> controls;
    if (!front.take(stride / 4, controls)) return false;
    for (std::size_t four = 0; four < stride / 4; ++four) {
      for (std::size_t k = 0; k < 4; ++k) {
        const unsigned control = byteAt(controls, four) >> (2 * k) & 3u;
        if (!decodeByte(front, control, size, deltas[k])) return false;
      }
      for (std::size_t v = 0; v < size; ++v) {
        addDeltas(byteAt(channels, four), {deltas[0][v], deltas[1][v], deltas[2][v], deltas[3][v]},
                  last.data() + 4 * four);
        for (std::size_t k = 0; k < 4; ++k) {
          vertices[(first + v) * stride + 4 * four + k] =
              static_cast<std::byte>(last[4 * four + k]);
        }
      }
    }
  }
  return front.left() == 0;
}

}  // namespace girth::io
