// What a command is. Each stands in a file of its own, with its options, its help and its work; the
// table of all of them is table.cpp.
#pragma once

#include <functional>
#include <span>

#include "cli_app.h"

namespace girth::cli {

/// Runs with the options that were parsed and returns the exit code: 0 done, 1 wrong usage, 2 bad
/// input, 3 a limit was met or the work was cancelled, 4 something is too thin to print.
using Run = std::function<int()>;

struct Command {
  const char* name;
  /// One line for the list of commands.
  const char* summary;
  /// Adds the options to the command's app. What is returned runs once the app has parsed them.
  Run (*add)(CLI::App& app);
};

/// Adds commands under an app, which then requires one of them. What is returned runs the one that
/// was parsed.
Run addCommands(CLI::App& app, std::span<const Command* const> commands);

/// All commands of `girth`, in the order of its help.
std::span<const Command* const> allCommands();

}  // namespace girth::cli
