// The commands, each defined in the file of its name.
#pragma once

#include "commands/command.h"

namespace girth::cli {

#define GIRTH_COMMAND(name) extern const Command k##name;
#include "commands/commands.def"

/// Under `girth study`.
extern const Command kStudyAccuracy, kStudyRobustness;

}  // namespace girth::cli
