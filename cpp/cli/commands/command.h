// A command. Each stands in a file of its own, with its options, its help and its work; the
// table of all of them is table.cpp.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "options/option_table.h"

namespace girth::cli {

/// Runs with the options that were parsed and returns the exit code, one of process/exit_codes.h.
using Run = std::function<int()>;

struct Command {
  const char* name;
  /// One line for the list of commands.
  const char* summary;
  /// Declares the options and examples. The returned function runs once they have been parsed. Null
  /// where there are commands below this one.
  Run (*add)(OptionTable& table);
  /// Commands of which one must follow: those of `girth study`.
  std::span<const Command* const> below{};
};

/// All commands of `girth`, in the order of its help.
std::span<const Command* const> allCommands();

/// A command with the words that it is called by, such as "girth study accuracy".
struct NamedCommand {
  std::string name;
  const Command* command;
};

/// All commands and those below them, each behind the one that it is below.
std::vector<NamedCommand> namedCommands();

/// The options of a command, with those that all commands have.
Run addOptions(const Command& command, OptionTable& table);

/// Runs what was typed behind `girth`, and returns the exit code. Reports wrong usage.
int runCommandLine(std::span<const std::string> arguments);

}  // namespace girth::cli
