// The cost of a computation.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <algorithm>
#include <cstddef>

namespace girth {

/// Windows and memory of one propagation, or of many together.
struct SearchStatistics {
  std::size_t sources{0};         ///< propagations
  std::size_t windowsCreated{0};  ///< windows made
  std::size_t windowsCrossed{0};  ///< windows that crossed their face before the end
  std::size_t peakBytes{0};       ///< memory of the solver that held most

  /// Adds the counts, and takes the greater memory.
  SearchStatistics& operator+=(const SearchStatistics& other) {
    sources += other.sources;
    windowsCreated += other.windowsCreated;
    windowsCrossed += other.windowsCrossed;
    peakBytes = std::max(peakBytes, other.peakBytes);
    return *this;
  }
};

}  // namespace girth
