// Counts what the program holds on the heap.
#pragma once

#include <cstddef>

namespace girth::bench {

/// Bytes that `new` has handed out and `delete` has not taken back, and the most there were at once
/// since `resetHeapPeak`. Counted in programs that link heap_meter.cpp, whose operators replace the
/// standard ones; a header of 16 bytes a block is not counted.
std::size_t heapBytes();
std::size_t heapPeakBytes();
void resetHeapPeak();

}  // namespace girth::bench
