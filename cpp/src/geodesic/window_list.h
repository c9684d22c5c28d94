// Where windows are kept: one growing list for each halfedge, its fields side by side, so that
// several windows can be computed at once; the memory is handed round.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "geodesic/window.h"

namespace girth::geodesic {

/// The windows of one halfedge, in the order of their coming. The first `entered` of them have
/// crossed its face, the others wait.
struct WindowList {
  double* data{nullptr};  ///< five arrays of `capacity()`: root.x, root.y, sigma, gapFrom, gapTo
  std::uint32_t count{0}, entered{0};
  std::uint32_t turn{kNotQueued};  ///< the bucket in which the halfedge waits for its turn
  /// The windows that have reached the corner opposite lie among these.
  std::uint32_t apexBegin{0xFFFFFFFFu}, apexEnd{0};
  std::uint8_t sizeClass{0};
  bool touched{false};   ///< something came here in this propagation
  bool released{false};  ///< windows were here, and are gone: the front has passed the face

  static constexpr std::uint32_t kNotQueued = 0xFFFFFFFFu;
  static constexpr std::uint32_t kSmallest = 8;

  std::uint32_t capacity() const { return data == nullptr ? 0 : kSmallest << sizeClass; }
  Window window(std::uint32_t i) const {
    const double* d = data + i;
    const std::size_t c = capacity();
    return {{d[0], d[c]}, d[2 * c], d[3 * c], d[4 * c]};
  }
};

/// Memory for window lists, in blocks of powers of two that are used again.
class WindowPool {
 public:
  /// Makes room for `more` further windows in a list.
  void reserve(WindowList& list, std::uint32_t more) {
    if (list.count + more > list.capacity()) grow(list, list.count + more);
  }
  /// Takes the windows of a list, and their memory, back.
  void release(WindowList& list) {
    if (list.data != nullptr) giveBack(list.data, list.sizeClass);
    list.data = nullptr;
    list.count = list.entered = list.apexEnd = 0;
    list.apexBegin = 0xFFFFFFFFu;
  }
  /// Forgets all lists at once: every block is free again.
  void reset();

  /// Bytes held by lists now, and in all.
  std::size_t bytesInUse() const { return used_; }
  std::size_t memoryBytes() const { return slabs_.size() * kSlab * sizeof(double) + largeBytes_; }

 private:
  static constexpr std::size_t kSlab = std::size_t{1} << 15;  // doubles
  static constexpr std::size_t kSpare = 4;  // a vector load may begin at the last window
  static std::size_t doublesOf(unsigned sizeClass) {
    return 5 * (std::size_t{WindowList::kSmallest} << sizeClass) + kSpare;
  }

  void grow(WindowList& list, std::uint32_t count);
  double* take(unsigned sizeClass);
  void giveBack(double* block, unsigned sizeClass);

  std::vector<std::unique_ptr<double[]>> slabs_;
  std::vector<std::unique_ptr<double[]>> large_;  // blocks too large for a slab
  std::size_t largeBytes_{0};
  std::size_t slab_{0}, offset_{0};  // where fresh memory begins
  std::array<double*, 32> free_{};  // by class; each free block begins with the address of the next
  std::size_t used_{0};
};

}  // namespace girth::geodesic
