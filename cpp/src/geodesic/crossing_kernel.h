// The arithmetic of crossing a face, for all the pending windows of a halfedge at once.
#pragma once

#include <cstdint>
#include <span>

#include "geodesic/unfolding.h"
#include "geodesic/window_list.h"

namespace girth::geodesic {

/// The pending windows of a halfedge, and what is known of its face's corners. (All are trimmed by
/// what was known before, so that the result is the same for any number of lanes.)
struct CrossingBatch {
  Crossing crossing;
  const WindowRun* newest;  ///< the last pending run; those before it follow by `older`
  std::uint32_t first;      ///< number of the first pending window
  std::uint32_t count;      ///< number of pending windows
  double distanceFrom, distanceTo,
      distanceApex;  ///< distances of the three corners; infinite: not reached
};

struct CrossingResult {
  std::uint32_t leftCount, rightCount;  ///< windows written
  double leftNearest, rightNearest;     ///< distance of the nearest point of those; infinite: none
  double distanceApex;                  ///< the corner's, now
  std::int32_t apexWindow;  ///< the window that came nearest to it; −1: none came nearer
  /// The windows that reach the corner, nearest or not, lie among these, counted within the batch.
  std::uint32_t apexBegin, apexEnd;
  bool towardsLeft, towardsRight;  ///< some window reaches that side or the corner, trimmed or not
};

/// Writes the windows that leave through either side behind the headers of runs with room for all
/// (WindowPool::reserve), whose counts it leaves alone. Null: none are wanted.
using CrossingKernel = CrossingResult (*)(const CrossingBatch&, WindowRun* left, WindowRun* right);

/// The kernels that this processor can run, the fastest first, the one that any can last. All give
/// the same bits.
std::span<const CrossingKernel> crossingKernels();

}  // namespace girth::geodesic
