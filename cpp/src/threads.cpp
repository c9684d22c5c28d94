#include "threads.h"

#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace girth {

void onThreads(unsigned threads, const ThreadBody& body) {
  std::atomic<bool> failed{false};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto live = [&](bool calling) {
    try {
      body(calling, failed);
    } catch (...) {
      failed = true;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  if (threads > 1) others.reserve(threads - 1);
  try {
    for (unsigned i = 1; i < threads; ++i) others.emplace_back(live, false);
  } catch (const std::exception&) {
    // No more threads are to be had: those that have started are enough.
  }
  live(true);
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace girth
