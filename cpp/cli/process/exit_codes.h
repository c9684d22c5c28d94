// The command's exit codes, as help, manual pages and the command itself have them.
#pragma once

#include <array>

namespace girth::cli {

struct ExitCode {
  int code;
  const char* meaning;
};

/// 1 to 3 are those of the errors in error_codes.def.
inline constexpr std::array kExitCodes{
    ExitCode{0, "done"}, ExitCode{1, "wrong usage"}, ExitCode{2, "bad input"},
    ExitCode{3, "a limit was met or the work was cancelled"},
    ExitCode{4, "a check fails: something is too thin to print"}};

/// The exit code of a check that fails, so that a build script can use it.
inline constexpr int kCheckFails = 4;

}  // namespace girth::cli
