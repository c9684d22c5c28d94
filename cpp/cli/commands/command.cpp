#include "commands/command.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

#include "girth/version.h"
#include "help/help_text.h"
#include "options/parse.h"
#include "process/report.h"

namespace girth::cli {
namespace {

bool asksForHelp(std::span<const std::string> arguments) {
  for (const std::string& argument : arguments) {
    if (argument == "--") return false;
    if (argument == "-h" || argument == "--help") return true;
  }
  return false;
}

int print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  return 0;
}

/// Refuses a word that was typed where a command was expected.
int noSuchCommand(const std::string& typed, const std::string& above,
                  std::span<const Command* const> commands) {
  std::vector<std::string> names;
  for (const Command* command : commands) names.emplace_back(command->name);
  const std::string near = nearestName(typed, names);
  return reportError(
      "", usageError("there is no command " + above + " " + typed,
                     near.empty() ? "see " + above + " --help" : "did you mean " + near + "?"));
}

/// Runs the command that the first argument names.
int runOneOf(std::span<const Command* const> commands, const std::string& above,
             std::span<const std::string> arguments) {
  if (arguments.empty() || arguments[0].empty() || arguments[0][0] == '-') {
    if (asksForHelp(arguments)) return print(helpOfCommands(above, commands));
    return reportError("", usageError(arguments.empty() ? "a command is missing"
                                                        : above + " has no option " + arguments[0],
                                      "see " + above + " --help"));
  }
  const auto found = std::find_if(commands.begin(), commands.end(), [&](const Command* command) {
    return arguments[0] == command->name;
  });
  if (found == commands.end()) return noSuchCommand(arguments[0], above, commands);
  const Command& command = **found;
  const std::string name = above + " " + command.name;
  const auto rest = arguments.subspan(1);
  if (!command.below.empty()) return runOneOf(command.below, name, rest);
  OptionTable table;
  const Run run = addOptions(command, table);
  if (asksForHelp(rest)) return print(helpOf(name, command, table));
  if (const auto error = parseArguments(table, rest, name)) return reportError("", *error);
  const bool isJson = std::any_of(
      table.options().begin(), table.options().end(),
      [](const Option& option) { return option.hasName("--json") && option.isGiven(); });
  if (isJson) printErrorsAsJson();
  for (const Option& option : table.options()) {
    if (!option.isFormerNameTyped()) continue;
    printNote("", option.formerName() + " is the older name of " + option.title() + ", until 2.0");
  }
  return run();
}

void addNamed(std::span<const Command* const> commands, const std::string& above,
              std::vector<NamedCommand>& all) {
  for (const Command* command : commands) {
    all.push_back({above + " " + command->name, command});
    addNamed(command->below, all.back().name, all);
  }
}

}  // namespace

std::vector<NamedCommand> namedCommands() {
  std::vector<NamedCommand> all;
  addNamed(allCommands(), "girth", all);
  return all;
}

Run addOptions(const Command& command, OptionTable& table) {
  Run run = command.add == nullptr ? Run() : command.add(table);
  table.onFlag(
      "-q,--quiet", [] { beQuiet(); },
      "Print errors only: no progress, no notes, no summary in words");
  table.onFlag(
      "-h,--help", [] {}, "Print this help");
  return run;
}

int runCommandLine(std::span<const std::string> arguments) {
  if (!arguments.empty() && (arguments[0] == "-V" || arguments[0] == "--version")) {
    return print(std::string("girth ") + GIRTH_VERSION + "\n");
  }
  if (!arguments.empty() && (arguments[0] == "-q" || arguments[0] == "--quiet")) {
    beQuiet();
    arguments = arguments.subspan(1);
  }
  if (arguments.empty()) {
    print(helpOfCommands("girth", allCommands()));
    return exitCodeOf(ErrorCode::Usage);
  }
  return runOneOf(allCommands(), "girth", arguments);
}

}  // namespace girth::cli
