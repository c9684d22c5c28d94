#include "girth/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include "threads.h"

namespace girth {

unsigned threadCount(const ExecutionContext& context) {
  return context.threads > 0 ? context.threads : std::max(1u, std::thread::hardware_concurrency());
}

bool parallelFor(std::size_t count, std::size_t grain, const ExecutionContext& context,
                 const std::function<void(std::size_t begin, std::size_t end)>& work) {
  constexpr double kProgressStep = 0.01;
  std::atomic<std::size_t> next{0}, done{0};
  const std::size_t parts = std::max<std::size_t>(1, (count + grain - 1) / grain);
  const auto threads = static_cast<unsigned>(std::min<std::size_t>(threadCount(context), parts));
  onThreads(threads, [&](bool calling, const std::atomic<bool>& failed) {
    double reported = 0;
    while (!context.cancelled() && !failed) {
      const std::size_t begin = next.fetch_add(grain, std::memory_order_relaxed);
      if (begin >= count) return;
      const std::size_t end = std::min(count, begin + grain);
      work(begin, end);
      const std::size_t finished = done.fetch_add(end - begin, std::memory_order_relaxed);
      const double fraction = static_cast<double>(finished) / static_cast<double>(count);
      if (calling && context.onProgress && fraction >= reported + kProgressStep) {
        reported = fraction;
        context.onProgress(fraction);
      }
    }
  });
  if (done.load() < count) return false;
  if (context.onProgress) context.onProgress(1);
  return true;
}

}  // namespace girth
