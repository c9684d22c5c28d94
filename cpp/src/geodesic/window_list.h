// Where windows are kept. Windows that come to a halfedge at once are a run: its fields side by
// side, so that several windows can be computed at once. Runs lie behind one another in blocks, in
// the order of their coming; a block is used again when all its runs are done with. Since what
// comes together is done with together, few blocks suffice for the front, and they stay in the
// cache.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <vector>

#include "geodesic/min_max.h"
#include "geodesic/window.h"

namespace girth::geodesic {

/// Windows that came to a halfedge together. Behind it lie five arrays, `stride` numbers apart:
/// root.x, root.y, sigma, gapFrom, gapTo. Vector loads and stores may touch numbers behind the
/// last.
struct WindowRun {
  WindowRun* older;     ///< the run that came to the halfedge before; null: none
  std::uint32_t begin;  ///< its first window's number at the halfedge
  std::uint32_t count;
  std::size_t stride;

  static constexpr std::size_t kFields = 5;
  static constexpr std::uint32_t kMostLanes = 4;  ///< lanes of vectors, at most

  double* fields() { return reinterpret_cast<double*>(this + 1); }
  const double* fields() const { return reinterpret_cast<const double*>(this + 1); }
  Window window(std::uint32_t i) const {
    const double* d = fields() + i;
    return {{d[0], d[stride]}, d[2 * stride], d[3 * stride], d[4 * stride]};
  }
};

/// The windows of one halfedge, numbered in the order of their coming. The first `entered` of them
/// have crossed its face, the others are pending.
struct WindowList {
  WindowRun* newest{nullptr};
  std::uint32_t count{0}, entered{0};
  std::uint32_t bucket{kNotQueued};  ///< bucket of the queue in which the halfedge is pending
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
  /// Two runs can be filled in at once.
  enum class Side : std::uint8_t { Left, Right };

  /// A run with room for `count` windows, to be filled in. The next call for this side gives the
  /// same room again, but for what `commit` keeps.
  WindowRun* reserve(Side side, std::uint32_t count) {
    Block*& block = current_[static_cast<std::size_t>(side)];
    const std::size_t stride = count + kSpare, bytes = bytesOf(stride, count);
    if (block == nullptr || block->used >= kBlockBytes || block->used + bytes > block->bytes) {
      block = open(bytes);
    }
    auto* memory = reinterpret_cast<std::byte*>(block) + block->used;
    return new (memory) WindowRun{nullptr, 0, 0, stride};
  }
  /// The last run of that side has got `count` pending windows, at least one. `tight`: it takes
  /// no more memory than they need, where the difference is worth the moving.
  void commit(Side side, WindowRun* run, std::uint32_t count, bool tight) {
    Block* block = current_[static_cast<std::size_t>(side)];
    run->count = count;
    if (tight && (count <= kFew || run->stride > count + kLoose)) tighten(run);
    block->used += bytesOf(run->stride, count);
    ++block->pending;
  }
  /// The windows of a run have crossed their face, and are of no use once all that is nearer than
  /// `farthest` is passed.
  static void crossed(const WindowRun* run, float farthest) {
    Block* block = blockOf(run);
    --block->pending;
    block->farthest = static_cast<float>(larger(block->farthest, farthest));
  }
  /// All that is nearer than `passed` is passed: blocks without another use are free again.
  void forget(float passed);
  /// Forgets all runs at once.
  void reset();

  /// Whether a block has come into use since the last call of `forget`.
  bool grown() const { return grown_; }
  std::size_t memoryBytes() const;

 private:
  /// Windows behind the last one that vector loads and stores may touch.
  static constexpr std::uint32_t kSpare = WindowRun::kMostLanes - 1;
  /// The fields of a run are moved together where that is soon done, with so few windows, or where
  /// it has room for so many too much.
  static constexpr std::uint32_t kFew = 8, kLoose = 8;
  /// A run larger than a block has a block of its own size.
  static constexpr std::size_t kBlockBytes = std::size_t{1} << 15;
  struct alignas(64) Block {
    std::size_t bytes, used;
    std::uint32_t pending;  ///< runs
    float farthest;         ///< the farthest of the runs that have crossed
  };
  struct Delete {
    void operator()(Block* block) const;
  };

  static constexpr std::size_t bytesOf(std::size_t stride, std::uint32_t count) {
    return sizeof(WindowRun) +
           ((WindowRun::kFields - 1) * stride + count + kSpare) * sizeof(double);
  }
  /// Moves the fields of a run together.
  static void tighten(WindowRun* run) {
    const std::size_t stride = run->stride, count = run->count;
    double* const fields = run->fields();
    // Two and two, which never overlap; what is written too much, the next field writes over.
    const auto move = [&](std::size_t field, std::size_t i) {
      double* const to = fields + field * count + i;
      const double* const from = fields + field * stride + i;
      std::memcpy(to, from, 2 * sizeof(double));
      std::memcpy(to + 2, from + 2, 2 * sizeof(double));
    };
    if (count <= 4) {
      for (std::size_t field = 1; field < WindowRun::kFields; ++field) move(field, 0);
    } else {
      for (std::size_t field = 1; field < WindowRun::kFields; ++field) {
        for (std::size_t i = 0; i < count; i += 4) move(field, i);
      }
    }
    run->stride = count;
  }

  /// Blocks begin at multiples of their usual size, and a run begins within the first of these.
  static Block* blockOf(const WindowRun* run) {
    const auto address = reinterpret_cast<std::uintptr_t>(run);
    return reinterpret_cast<Block*>(address & ~(std::uintptr_t{kBlockBytes} - 1));
  }
  Block* open(std::size_t bytes);

  std::vector<std::unique_ptr<Block, Delete>> blocks_;  // all; the first `used_` are in use
  std::size_t used_{0};
  std::array<Block*, 2> current_{};  // where the next run of a side goes
  bool grown_{false};
};

}  // namespace girth::geodesic
