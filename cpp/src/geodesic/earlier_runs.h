// Windows of a call that propagates several times.
#pragma once

#include <cstddef>

#include "geodesic/propagation.h"

namespace girth::geodesic {

/// The windows of all runs of a call before its last, whose windows the propagation counts.
struct EarlierRuns {
  std::size_t created{0}, crossed{0};

  /// The last run is followed by another one.
  void add(const Propagation& propagation) {
    created += propagation.windowsCreated();
    crossed += propagation.windowsCrossed();
  }
};

}  // namespace girth::geodesic
