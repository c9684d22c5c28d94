// How large a model may become while it is read.
#pragma once

#include <algorithm>
#include <cstdint>

namespace girth::io {

/// The most triangles that a scene may have by placing its meshes more than once. In memory of 32
/// bits, that of WebAssembly, fewer have room.
constexpr std::uint64_t kMostPlacedTriangles = sizeof(void*) == 4 ? 3'000'000 : 10'000'000;

/// Counts down vertices and triangles. A mesh that is stored once stays in proportion to the file;
/// what is placed again, in proportion to the triangles that the scene says it has.
class SoupBudget {
 public:
  /// Makes room for what so many bytes may describe.
  void allowFor(std::uint64_t bytes) {
    bytes_ += bytes;
    left_ += 4 * bytes;
  }

  /// All bytes that room was made for.
  std::uint64_t bytes() const { return bytes_; }

  /// Makes room for so many elements of meshes that are placed again, as far as their triangles
  /// need them: three corners each, and three vertices with joints and weights. At most
  /// kMostPlacedTriangles.
  void allowAgain(std::uint64_t elements, std::uint64_t triangles) {
    left_ += std::min(elements, 12 * triangles);
  }

  /// Whether there is room for `count` more; if so they are taken.
  bool take(std::uint64_t count) {
    if (count > left_) return false;
    left_ -= count;
    return true;
  }

 private:
  // Small files may hold much that is not written down: zeros, fans, packed meshes.
  std::uint64_t left_{4'000'000};
  std::uint64_t bytes_{0};
};

}  // namespace girth::io
