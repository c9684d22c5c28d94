// One kind of work on many things, on all threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "girth/execution.h"

namespace girth {

/// Threads that a context asks for.
inline unsigned threadsOf(const ExecutionContext& context) {
  return context.threads > 0 ? context.threads : std::max(1u, std::thread::hardware_concurrency());
}

/// Calls `work(begin, end)` for ranges that make up 0 … count − 1, from several threads at once,
/// the calling one among them; with one thread, from that alone (so it runs where there are no
/// threads). `work` must not throw. Reports progress; false if it was cancelled before all was
/// done.
template <class Work>
bool inParallel(std::size_t count, std::size_t grain, const ExecutionContext& context, Work work) {
  std::atomic<std::size_t> next{0}, done{0};
  const auto take = [&](bool reports) {
    double reported = 0;
    while (!context.cancelled()) {
      const std::size_t begin = next.fetch_add(grain, std::memory_order_relaxed);
      if (begin >= count) return;
      const std::size_t end = std::min(count, begin + grain);
      work(begin, end);
      const std::size_t finished = done.fetch_add(end - begin, std::memory_order_relaxed);
      const double fraction = static_cast<double>(finished) / static_cast<double>(count);
      if (reports && context.onProgress && fraction >= reported + 0.01) {
        reported = fraction;
        context.onProgress(fraction);
      }
    }
  };
  const std::size_t parts = (count + grain - 1) / std::max<std::size_t>(1, grain);
  const auto threads = static_cast<unsigned>(
      std::min<std::size_t>(threadsOf(context), std::max<std::size_t>(1, parts)));
  std::vector<std::thread> others;
  for (unsigned i = 1; i < threads; ++i) others.emplace_back([&] { take(false); });
  take(true);
  for (std::thread& other : others) other.join();
  if (done.load() < count) return false;
  if (context.onProgress) context.onProgress(1);
  return true;
}

}  // namespace girth
