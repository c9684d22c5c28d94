// Interruption by Ctrl-C, or by a terminal that is closed.
#pragma once

#include <atomic>

namespace girth::cli {

/// From now on the first SIGINT, SIGTERM or SIGHUP sets the flag that is returned instead of ending
/// the program; the second one ends it.
const std::atomic<bool>& catchInterrupts();

}  // namespace girth::cli
