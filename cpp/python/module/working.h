// Long calls from Python: without the interpreter's lock, stopped by Ctrl-C, with progress.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "girth/error.h"
#include "girth/execution.h"

namespace girth::python {

/// The options that every long call takes.
struct Running {
  /// As in ExecutionContext.
  unsigned threads{0};
  /// A callable that takes the finished share in [0, 1], or None. An exception that it raises stops
  /// the work and is raised again.
  pybind11::object progress;
};

/// Calls `work` on a thread of its own and waits for it without the interpreter's lock. Every 20 ms
/// it looks after signals and reports progress; where a signal's handler or `progress` raises, the
/// work is cancelled and that exception is thrown. Work that does not stop soon is left to end by
/// itself (waitForAbandoned), and so must own all that it uses. An exception that `work` throws is
/// thrown again; for lack of memory, as a ThrownError.
void runWork(const Running& running, std::function<void(const ExecutionContext& context)> work);

/// Runs work that has a result. Throws the error, where there is one, as a ThrownError.
template <class Value>
Value compute(const Running& running,
              std::function<Result<Value>(const ExecutionContext& context)> work) {
  const auto result = std::make_shared<std::optional<Result<Value>>>();
  runWork(running, [result, work = std::move(work)](const ExecutionContext& context) {
    result->emplace(work(context));
  });
  return std::move(**result).value();
}

/// Waits for work that was left to end by itself: before the interpreter ends.
void waitForAbandoned();

}  // namespace girth::python
