// Looking, in loops of many short steps, whether the work has been asked to stop.
#pragma once

#include <cstdint>

#include "girth/error.h"
#include "girth/execution.h"

namespace girth::remeshing {

/// Asked at every step, it looks at every 256th: within milliseconds.
class Lookout {
 public:
  explicit Lookout(const ExecutionContext& context) : context_(context) {}

  /// Once true, it stays so.
  bool stopped() {
    if (++steps_ % 256 == 0) stopped_ = stopped_ || context_.cancelled();
    return stopped_;
  }
  /// The same, looked at now.
  bool stoppedByNow() { return stopped_ = stopped_ || context_.cancelled(); }

  static Error error() { return makeError(ErrorCode::Cancelled, -1, "cancelled"); }

 private:
  const ExecutionContext& context_;
  std::uint32_t steps_{0};
  bool stopped_{false};
};

}  // namespace girth::remeshing
