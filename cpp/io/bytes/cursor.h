// Numbers out of binary files, in either byte order, never past the end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace girth::io {

enum class ByteOrder : std::uint8_t { Little, Big };

/// The number of type T that is stored at `bytes`.
template <class T>
T loadAs(const std::byte* bytes, ByteOrder order) {
  // Put together byte by byte, so that it does not matter which order this machine has; compilers
  // make one instruction of it.
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    const std::size_t shift = 8 * (order == ByteOrder::Little ? i : sizeof(T) - 1 - i);
    bits |= std::to_integer<std::uint64_t>(bytes[i]) << shift;
  }
  T value;
  if constexpr (sizeof(T) == 8) {
    std::memcpy(&value, &bits, sizeof(T));
  } else if constexpr (sizeof(T) == 4) {
    const auto narrow = static_cast<std::uint32_t>(bits);
    std::memcpy(&value, &narrow, sizeof(T));
  } else if constexpr (sizeof(T) == 2) {
    const auto narrow = static_cast<std::uint16_t>(bits);
    std::memcpy(&value, &narrow, sizeof(T));
  } else {
    const auto narrow = static_cast<std::uint8_t>(bits);
    std::memcpy(&value, &narrow, sizeof(T));
  }
  return value;
}

/// A place in a binary file.
class BinaryCursor {
 public:
  BinaryCursor(std::span<const std::byte> bytes, std::size_t at, ByteOrder order)
      : bytes_(bytes), at_(at), order_(order) {}

  std::size_t offset() const { return at_; }
  std::size_t remaining() const { return bytes_.size() - at_; }

  /// Passes so many bytes; false, and nothing passed, where there are fewer.
  bool skip(std::uint64_t count) {
    if (count > remaining()) return false;
    at_ += static_cast<std::size_t>(count);
    return true;
  }
  /// The next number; false where the file ends within it.
  template <class T>
  bool take(T& value) {
    if (sizeof(T) > remaining()) return false;
    value = loadAs<T>(&bytes_[at_], order_);
    at_ += sizeof(T);
    return true;
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_;
  ByteOrder order_;
};

}  // namespace girth::io
