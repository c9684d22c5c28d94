// Numbers into the content of binary files, little-endian.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "bytes/bit_cast.h"

namespace girth::io {

/// Appends the lowest `count` bytes of `bits` to a text or a list of bytes.
template <class Content>
void appendBytes(Content& content, std::uint64_t bits, std::size_t count) {
  typename Content::value_type bytes[8];
  for (std::size_t i = 0; i < count; ++i) {
    bytes[i] = static_cast<typename Content::value_type>(bits >> (8 * i) & 0xFFu);
  }
  content.insert(content.end(), bytes, bytes + count);
}

template <class Content>
void appendDouble(Content& content, double value) {
  appendBytes(content, bitCast<std::uint64_t>(value), 8);
}

/// The nearest float; beyond the largest, the largest. Not for NaN.
inline float nearestFloat(double value) {
  constexpr double kLargest = static_cast<double>(std::numeric_limits<float>::max());
  return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

template <class Content>
void appendFloat(Content& content, float value) {
  appendBytes(content, bitCast<std::uint32_t>(value), 4);
}

}  // namespace girth::io
