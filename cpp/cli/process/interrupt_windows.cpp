// On Windows a thread of its own hears Ctrl-C, Ctrl-Break, and that the console is closed.
#include "process/interrupt.h"

#include <windows.h>

namespace girth::cli {
namespace {

std::atomic<bool> wasInterrupted{false};

BOOL WINAPI onEvent(DWORD event) {
  if (wasInterrupted.exchange(true, std::memory_order_relaxed)) return FALSE;
  // Closing the console ends the program once this thread returns. So it waits, and the program has
  // time to write its results.
  if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT) Sleep(INFINITE);
  return TRUE;
}

}  // namespace

const std::atomic<bool>& catchInterrupts() {
  static const BOOL added = SetConsoleCtrlHandler(onEvent, TRUE);
  static_cast<void>(added);
  return wasInterrupted;
}

}  // namespace girth::cli
