#include "gltf/unpack/meshopt.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "gltf/document/fault.h"
#include "gltf/unpack/meshopt_vertices.h"

namespace girth::io {
namespace {

using Mode = GltfMeshopt::Mode;
using Filter = GltfMeshopt::Filter;

/// The demand of KHR_meshopt_compression (and of EXT_meshopt_compression, its first version) that
/// an extension's members do not meet; empty if all is well.
std::string faultOf(const GltfMeshopt& packed) {
  const std::uint64_t stride = packed.byteStride;
  if (packed.count == 0) return "has a count of 0";
  const std::string bad = "has a byteStride of " + std::to_string(stride) + ", which its ";
  if (packed.mode == Mode::Attributes) {
    if (stride < 4 || stride > 256 || stride % 4 != 0) return bad + "mode does not allow";
  } else {
    if (stride != 2 && stride != 4) return bad + "mode does not allow";
    if (packed.filter != Filter::None) return "has a filter, which its mode does not allow";
    if (packed.mode == Mode::Triangles && packed.count % 3 != 0) {
      return "has a count of " + std::to_string(packed.count) +
             ", which is not a whole number of triangles";
    }
  }
  const bool fourOrEight = stride == 4 || stride == 8;
  const bool fits = packed.filter == Filter::None || packed.filter == Filter::Exponential ||
                    (packed.filter == Filter::Quaternion ? stride == 8 : fourOrEight);
  return fits ? std::string() : bad + "filter does not allow";
}

/// The fewest bytes in which so many elements can be packed.
std::uint64_t leastBytes(const GltfMeshopt& packed, std::span<const std::byte> bytes) {
  switch (packed.mode) {
    case Mode::Attributes:
      return leastMeshoptVertexBytes(packed.count, packed.byteStride, bytes);
    case Mode::Triangles:
      return 1 + packed.count / 3 + 16;
    case Mode::Indices:
      break;
  }
  return 1 + packed.count + 4;
}

/// Undoes the colour filter, which Debian's meshoptimizer does not know: appendix B of
/// KHR_meshopt_compression. Y, Co, Cg and alpha, of as many bits as alpha has, become red, green,
/// blue and alpha of the full range.
template <class Unsigned>
void undoColorFilter(std::vector<std::byte>& bytes) {
  const auto asSigned = [](int bits) {
    constexpr int kValues = 1 << (8 * sizeof(Unsigned));
    return bits < kValues / 2 ? bits : bits - kValues;
  };
  for (std::size_t at = 0; at + 4 * sizeof(Unsigned) <= bytes.size(); at += 4 * sizeof(Unsigned)) {
    Unsigned stored[4];
    std::memcpy(stored, bytes.data() + at, sizeof stored);
    const int y = stored[0];
    const int orange = asSigned(stored[1]), green = asSigned(stored[2]);
    const unsigned alpha = stored[3];
    unsigned range = 1;  // the least 2^n - 1 that is not below alpha
    while (range < alpha) range = range * 2 + 1;
    const unsigned half = alpha & (range >> 1);
    const double scale = static_cast<double>(static_cast<Unsigned>(-1)) / range;
    const auto full = [&](int value) {
      return static_cast<Unsigned>(static_cast<int>(std::floor(value * scale + 0.5)));
    };
    const Unsigned shown[4] = {full(y + orange - green), full(y + green), full(y - orange - green),
                               full(static_cast<int>(half * 2 + (half & 1)))};
    std::memcpy(bytes.data() + at, shown, sizeof shown);
  }
}

void undoFilter(const GltfMeshopt& packed, std::vector<std::byte>& bytes) {
  const auto count = static_cast<std::size_t>(packed.count);
  const auto stride = static_cast<std::size_t>(packed.byteStride);
  switch (packed.filter) {
    case Filter::None:
      break;
    case Filter::Octahedral:
      meshopt_decodeFilterOct(bytes.data(), count, stride);
      break;
    case Filter::Quaternion:
      meshopt_decodeFilterQuat(bytes.data(), count, stride);
      break;
    case Filter::Exponential:
      meshopt_decodeFilterExp(bytes.data(), count, stride);
      break;
    case Filter::Color:
      if (stride == 4) {
        undoColorFilter<std::uint8_t>(bytes);
      } else {
        undoColorFilter<std::uint16_t>(bytes);
      }
      break;
  }
}

bool decode(const GltfMeshopt& packed, std::span<const std::byte> bytes,
            std::vector<std::byte>& content) {
  const auto count = static_cast<std::size_t>(packed.count);
  const auto stride = static_cast<std::size_t>(packed.byteStride);
  const auto* source = reinterpret_cast<const unsigned char*>(bytes.data());
  switch (packed.mode) {
    case Mode::Attributes:
      if (isMeshoptVertexVersion1(bytes)) {
        return decodeMeshoptVertexVersion1(content, count, stride, bytes);
      }
      return meshopt_decodeVertexBuffer(content.data(), count, stride, source, bytes.size()) == 0;
    case Mode::Triangles:
      return meshopt_decodeIndexBuffer(content.data(), count, stride, source, bytes.size()) == 0;
    case Mode::Indices:
      break;
  }
  return meshopt_decodeIndexSequence(content.data(), count, stride, source, bytes.size()) == 0;
}

}  // namespace

Result<std::vector<std::byte>> unpackMeshopt(const GltfMeshopt& packed,
                                             std::span<const std::byte> bytes, SoupBudget& budget,
                                             const std::string& place) {
  if (const std::string fault = faultOf(packed); !fault.empty()) return faultAt(place, fault);
  if (bytes.size() < leastBytes(packed, bytes)) {
    return faultAt(place, "claims " + std::to_string(packed.count) +
                              " elements, which do not fit into its " +
                              std::to_string(bytes.size()) + " bytes");
  }
  // A point and its triangles take about 16 bytes of such views.
  if (!budget.take(packed.count * packed.byteStride / 16 + 1)) {
    return makeError(ErrorCode::LimitExceeded, -1,
                     place + ": its " + std::to_string(packed.count) +
                         " elements make the model far larger than its file");
  }
  std::vector<std::byte> content(static_cast<std::size_t>(packed.count * packed.byteStride));
  if (!decode(packed, bytes, content)) {
    return faultAt(place, "its packed bytes are not valid");
  }
  undoFilter(packed, content);
  return content;
}

}  // namespace girth::io
