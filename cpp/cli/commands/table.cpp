#include "commands/table.h"

#include <array>

namespace girth::cli {

std::span<const Command* const> allCommands() {
  static constexpr std::array kAll{
#define GIRTH_COMMAND(name) &k##name,
#include "commands/commands.def"
  };
  return kAll;
}

}  // namespace girth::cli
