// Progress with the time left, on one line of a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace girth::cli {

/// Writes to standard error, and only where that is a terminal; the line is gone when it is
/// finished.
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

}  // namespace girth::cli
