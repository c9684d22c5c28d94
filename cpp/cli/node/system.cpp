// Functions of the C library that Emscripten's answers without asking the system, asked of Node.js
// instead.
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "node/node.h"

extern "C" {

pid_t getpid() { return girthProcessId(); }

int isatty(int descriptor) { return girthIsTerminal(descriptor); }

int access(const char* path, int mode) {
  const int failure = girthAccess(path, mode);
  if (failure != 0) errno = failure;
  return failure == 0 ? 0 : -1;
}
}

namespace {

/// Emscripten's C library takes standard output for a terminal, which it would write line by line.
[[maybe_unused]] const int kBuffered =
    girthIsTerminal(STDOUT_FILENO) != 0 ? 0 : std::setvbuf(stdout, nullptr, _IOFBF, 1 << 16);

}  // namespace
