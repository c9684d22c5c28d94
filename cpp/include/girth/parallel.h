// Work on many things at once, on the threads that a context asks for.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstddef>
#include <functional>

#include "girth/execution.h"
#include "girth/export.h"

namespace girth {

/// Threads that a context asks for: `context.threads`, or one for each core of the machine where
/// that is 0. At least 1.
GIRTH_EXPORT unsigned threadCount(const ExecutionContext& context);

/// Calls `work(begin, end)` for ranges of at most `grain` (1 or more) that make up 0 … `count` − 1,
/// from several threads at once, the calling one among them; with one thread, from that alone.
/// Reports progress on the calling thread. Returns whether all was done: false where the context
/// was cancelled before. An exception of `work` ends the work and is thrown again on the
/// calling thread; of several, the first.
GIRTH_EXPORT bool parallelFor(std::size_t count, std::size_t grain, const ExecutionContext& context,
                              const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace girth
