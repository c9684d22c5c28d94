#include "commands/command.h"

#include <CLI/CLI.hpp>
#include <utility>
#include <vector>

namespace girth::cli {

Run addCommands(CLI::App& app, std::span<const Command* const> commands) {
  app.require_subcommand(1);
  std::vector<std::pair<const CLI::App*, Run>> runs;
  for (const Command* command : commands) {
    CLI::App* added = app.add_subcommand(command->name, command->summary);
    runs.emplace_back(added, command->add(*added));
  }
  return [runs = std::move(runs)] {
    for (const auto& [command, run] : runs) {
      if (command->parsed()) return run();
    }
    return 1;
  };
}

}  // namespace girth::cli
