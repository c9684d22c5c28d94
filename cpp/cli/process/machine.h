// The machine that the program runs on.
#pragma once

#include <string>

namespace girth::cli {

/// Its name in the network; empty where it has none.
std::string machineName();

}  // namespace girth::cli
