// Cancellation in loops of many short steps.
#pragma once

#include <cstdint>

#include "girth/error.h"
#include "girth/execution.h"

namespace girth::remeshing {

/// Call stopped() at every step; every 256th call asks the context, which is within milliseconds.
class CancellationPoll {
 public:
  explicit CancellationPoll(const ExecutionContext& context) : context_(context) {}

  /// Once true, it stays so.
  bool stopped() {
    if (++steps_ % 256 == 0) stopped_ = stopped_ || context_.cancelled();
    return stopped_;
  }
  /// As stopped(), but this call asks the context.
  bool stoppedByNow() { return stopped_ = stopped_ || context_.cancelled(); }

  static Error error() { return makeError(ErrorCode::Cancelled, -1, "cancelled"); }

 private:
  const ExecutionContext& context_;
  std::uint32_t steps_{0};
  bool stopped_{false};
};

}  // namespace girth::remeshing
