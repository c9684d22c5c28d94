// Progress with the time left, on one line of a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "girth/execution.h"

namespace girth::cli {

/// Writes to standard error, and only where that is a terminal. The destructor clears the line.
class ProgressLine {
 public:
  explicit ProgressLine(std::string label);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(double fraction);

 private:
  using Clock = std::chrono::steady_clock;

  std::string label_;
  bool onTerminal_;
  std::size_t width_{0};
  Clock::time_point started_;
  Clock::time_point shown_;
};

/// Work on so many threads (0: as many as there are cores), its progress on the line, until Ctrl-C.
ExecutionContext watched(unsigned threads, ProgressLine& progress);

}  // namespace girth::cli
