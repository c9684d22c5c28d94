#include "program.h"

#include <cstdio>
#include <exception>
#include <new>

#include "commands/command.h"
#include "process/report.h"

namespace girth::cli {

int runProgram(const std::vector<std::string>& arguments) {
  int exitCode = 0;
  try {
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

}  // namespace girth::cli
