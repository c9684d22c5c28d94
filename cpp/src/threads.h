// The one place where threads start and are joined.
#pragma once

#include <atomic>
#include <functional>

namespace girth {

/// The life of one thread. `calling`: it is the thread that called `onThreads`. Should end soon
/// once `failed` is set.
using ThreadBody = std::function<void(bool calling, const std::atomic<bool>& failed)>;

/// Runs `body` on `threads` threads at once, the calling one among them, and returns when all have
/// ended. An exception that a body throws sets `failed` and is thrown again here; of several
/// exceptions, the first. Where the system has fewer threads left, those that there are do the
/// work.
void onThreads(unsigned threads, const ThreadBody& body);

}  // namespace girth
