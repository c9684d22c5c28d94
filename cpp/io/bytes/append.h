// Numbers into the content of binary files, little-endian.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "bytes/bit_cast.h"

namespace girth::io {

/// Appends the lowest `count` bytes of `bits`.
inline void appendBytes(std::string& content, std::uint64_t bits, std::size_t count) {
  char bytes[8];
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<char>(bits >> (8 * i) & 0xFFu);
  content.append(bytes, count);
}

inline void appendDouble(std::string& content, double value) {
  appendBytes(content, bitCast<std::uint64_t>(value), 8);
}

/// The nearest float; beyond the largest, the largest. Not for NaN.
inline float nearestFloat(double value) {
  constexpr double kLargest = static_cast<double>(std::numeric_limits<float>::max());
  return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

inline void appendFloat(std::string& content, float value) {
  appendBytes(content, bitCast<std::uint32_t>(value), 4);
}

}  // namespace girth::io
