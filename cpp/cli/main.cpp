// girth: the intrinsic girth function on the command line.
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "commands/command.h"
#include "process/report.h"

int main(int argc, char** argv) {
  using namespace girth;
  using namespace girth::cli;
  int exitCode = 0;
  try {
    const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
    exitCode = runCommandLine(arguments);
  } catch (const std::bad_alloc&) {
    exitCode = reportError("", makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory"));
  } catch (const std::exception& error) {
    exitCode = reportError("", makeError(ErrorCode::Internal, -1, error.what()));
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    const int unwritable = reportError(
        "standard output", makeError(ErrorCode::FileUnwritable, -1, "it cannot be written"));
    if (exitCode == 0) exitCode = unwritable;
  }
  return exitCode;
}
