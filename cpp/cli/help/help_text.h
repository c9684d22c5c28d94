// Help as `girth help COMMAND` and `girth COMMAND --help` print it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "commands/command.h"
#include "options/option_table.h"

namespace girth::cli {

/// The program in one sentence.
std::string_view programSummary();

/// Which models are read, and how their vertices are numbered.
std::string_view modelWords();

/// The end of every page of help: formats, numbering, exit codes.
std::string helpEnd();

/// "girth igf MODEL... [options]".
std::string usageOf(const std::string& name, const OptionTable& table);

/// An option with what stands for its value, as in "-o, --output FILE".
std::string declarationOf(const Option& option);

/// The meaning of an option, with the values that it takes.
std::string meaningOf(const Option& option);

/// The help of one command. `name`: what it is called by, "girth igf".
std::string helpOf(const std::string& name, const Command& command, const OptionTable& table);

/// The help of `girth`, or of a command with others below it.
std::string helpOfCommands(const std::string& name, std::span<const Command* const> commands);

}  // namespace girth::cli
