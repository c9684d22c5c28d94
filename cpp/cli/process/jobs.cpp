#include "process/jobs.h"

#include <algorithm>
#include <atomic>

#include "process/forked_jobs.h"
#include "process/interrupt.h"

namespace girth::cli {
namespace {

/// WebAssembly and Windows cannot fork: the models follow each other, with the same output.
#if defined(__EMSCRIPTEN__) || defined(_WIN32)
constexpr bool kCanFork = false;
#else
constexpr bool kCanFork = true;
#endif

}  // namespace

int forEachJob(std::span<const std::string> items, unsigned jobs,
               const std::function<int(std::size_t item)>& work) {
  if constexpr (kCanFork) {
    if (jobs > 1 && items.size() > 1) return forkedJobs(items, jobs, work);
  }
  const std::atomic<bool>& interrupted = catchInterrupts();
  int greatest = 0;
  for (std::size_t i = 0; i < items.size() && !interrupted; ++i) {
    greatest = std::max(greatest, work(i));
  }
  return greatest;
}

}  // namespace girth::cli
