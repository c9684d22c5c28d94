// Arguments as they are typed, taken by an option table.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "girth/error.h"
#include "options/option_table.h"

namespace girth::cli {

/// Lets the table's options and arguments take what was typed behind the command. `--name value`,
/// `--name=value`, `-n value` and `-nvalue` mean the same; behind `--` everything is an argument;
/// so is `-`, and what looks like a negative number. `command`: for messages, as in "girth igf".
/// Error: USAGE, with the option that may have been meant, or the help to look at.
std::optional<Error> parseArguments(OptionTable& table, std::span<const std::string> arguments,
                                    const std::string& command);

/// The one of `names` that was probably meant by `typed`; empty where none is near.
std::string nearestName(const std::string& typed, std::span<const std::string> names);

}  // namespace girth::cli
