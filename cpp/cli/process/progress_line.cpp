#include "process/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "process/interrupt.h"
#include "process/report.h"

namespace girth::cli {

ProgressLine::ProgressLine(std::string label)
    : label_(std::move(label)),
      onTerminal_(!isQuiet() && isatty(STDERR_FILENO) != 0),
      started_(Clock::now()),
      shown_(started_) {}

ProgressLine::~ProgressLine() {
  if (width_ > 0) std::fprintf(stderr, "\r%*s\r", static_cast<int>(width_), "");
}

void ProgressLine::show(double fraction) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (!onTerminal_ || now - shown_ < 100ms) return;
  shown_ = now;
  std::string line = label_ + ": " + std::to_string(static_cast<int>(100 * fraction)) + " %";
  if (fraction > 0.02) {
    const double elapsed = std::chrono::duration<double>(now - started_).count();
    line += ", " + readableTime(elapsed / fraction * (1 - fraction)) + " left";
  }
  const std::size_t padded = std::max(width_, line.size());
  std::fprintf(stderr, "\r%-*s", static_cast<int>(padded), line.c_str());
  width_ = padded;
}

ExecutionContext watched(unsigned threads, ProgressLine& progress) {
  return {threads, &catchInterrupts(), [&progress](double fraction) { progress.show(fraction); }};
}

}  // namespace girth::cli
