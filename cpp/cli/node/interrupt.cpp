#include "process/interrupt.h"

#include "node/node.h"

namespace girth::cli {

const std::atomic<bool>& catchInterrupts() {
  static std::atomic<bool> interrupted{false};
  static_assert(sizeof interrupted == 1, "a byte is set");
  static const bool isCaught = [] {
    girthCatchSignals(&interrupted);
    return true;
  }();
  (void)isCaught;
  return interrupted;
}

}  // namespace girth::cli
