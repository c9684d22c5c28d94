// How long calls run: on how many threads, with what progress, and until when.
#pragma once

#include <atomic>
#include <functional>

namespace girth {

/// Handed to every long call. The defaults are right for a plain call.
struct ExecutionContext {
  /// Threads to use; 0 means one for each core. Results never depend on it.
  unsigned threads{0};

  /// Set it to true, from any thread, to stop the work; null means it cannot be stopped. The call
  /// then returns within milliseconds with what is finished, marked as partial.
  const std::atomic<bool>* cancel{nullptr};

  /// Called on the calling thread with the finished share in [0, 1]. Never falls; the last call of
  /// work that was not cancelled is 1.
  std::function<void(double fraction)> onProgress{};

  /// Whether the work has been asked to stop.
  bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }

  /// The context of one of several threads: stopped by the same `cancel`, without progress.
  ExecutionContext ofOneThread() const { return {1, cancel, {}}; }
};

}  // namespace girth
