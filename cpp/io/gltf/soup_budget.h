// How large a model may become while it is read.
#pragma once

#include <cstdint>

namespace girth::io {

/// Counts down vertices and triangles. A few bytes of glTF can ask for one mesh at a million nodes;
/// what is made from a file stays in proportion to the file.
class SoupBudget {
 public:
  /// Makes room for what so many bytes may describe, instances included.
  void allowFor(std::uint64_t bytes) { left_ += 4 * bytes; }

  /// Whether there is room for `count` more; if so they are taken.
  bool take(std::uint64_t count) {
    if (count > left_) return false;
    left_ -= count;
    return true;
  }

 private:
  // Small files may place a small mesh many times.
  std::uint64_t left_{4'000'000};
};

}  // namespace girth::io
