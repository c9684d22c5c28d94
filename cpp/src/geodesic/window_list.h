// Where windows are kept. What comes to a halfedge at once is a run: its fields side by side, so
// that several windows can be computed at once. Runs lie behind one another in blocks, in the order
// of their coming; a block is used again when all its runs are done with. Since what comes together
// is done with together, few blocks suffice for the front, and they stay in the cache.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "geodesic/window.h"

namespace girth::geodesic {

/// Windows that came to a halfedge together. Behind it lie five arrays of `stride()` numbers:
/// root.x, root.y, sigma, gapFrom, gapTo.
struct WindowRun {
  WindowRun* older;     ///< the run that came to the halfedge before; null: none
  std::uint32_t begin;  ///< its first window's number at the halfedge
  std::uint32_t count;

  static constexpr std::size_t kFields = 5;
  static constexpr std::size_t strideOf(std::uint32_t count) { return (count + 1u) & ~1u; }

  std::size_t stride() const { return strideOf(count); }
  double* fields() { return reinterpret_cast<double*>(this + 1); }
  const double* fields() const { return reinterpret_cast<const double*>(this + 1); }
  Window window(std::uint32_t i) const {
    const double* d = fields() + i;
    const std::size_t n = stride();
    return {{d[0], d[n]}, d[2 * n], d[3 * n], d[4 * n]};
  }
};

/// The windows of one halfedge, numbered in the order of their coming. The first `entered` of them
/// have crossed its face, the others wait.
struct WindowList {
  WindowRun* newest{nullptr};
  std::uint32_t count{0}, entered{0};
  std::uint32_t turn{kNotQueued};  ///< the bucket in which the halfedge waits for its turn
  /// The windows that have reached the corner opposite lie among these.
  std::uint32_t apexBegin{0xFFFFFFFFu}, apexEnd{0};
  /// No point of the face is farther; known when the first windows cross it.
  float farthest{std::numeric_limits<float>::infinity()};

  static constexpr std::uint32_t kNotQueued = 0xFFFFFFFFu;

  Window window(std::uint32_t number) const {
    const WindowRun* run = newest;
    while (run->begin > number) run = run->older;
    return run->window(number - run->begin);
  }
};

/// Memory for runs of windows.
class WindowPool {
 public:
  /// A run of `count` windows, which waits: to be filled in. Up to kSpare numbers behind it may be
  /// read.
  WindowRun* take(std::uint32_t count);
  /// The windows of a run have crossed their face, and are of no use once all that is nearer than
  /// `farthest` is passed.
  static void crossed(const WindowRun* run, float farthest) {
    Block* block = blockOf(run);
    --block->waiting;
    if (block->farthest < farthest) block->farthest = farthest;
  }
  /// All that is nearer than `passed` is passed: blocks without another use are free again.
  void forget(float passed);
  /// Forgets all runs at once.
  void reset();

  /// Whether a block has come into use since the last call of `forget`.
  bool grown() const { return grown_; }
  std::size_t memoryBytes() const;

  static constexpr std::size_t kSpare = 4;

 private:
  /// A run larger than a block has a block of its own size.
  static constexpr std::size_t kBlockBytes = std::size_t{1} << 15;
  struct alignas(64) Block {
    std::size_t bytes, used;
    std::uint32_t waiting;  ///< runs
    float farthest;         ///< of those that wait no more
  };
  struct Delete {
    void operator()(Block* block) const;
  };

  /// Blocks begin at multiples of their usual size, and a run begins within the first of these.
  static Block* blockOf(const WindowRun* run);
  void open(std::size_t bytes);

  std::vector<std::unique_ptr<Block, Delete>> blocks_;  // all; the first `used_` are in use
  std::size_t used_{0};
  Block* current_{nullptr};
  bool grown_{false};
};

}  // namespace girth::geodesic
