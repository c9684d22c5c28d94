// The program from its words to its exit code.
#pragma once

#include <string>
#include <vector>

namespace girth::cli {

/// Runs the command line `arguments`, in UTF-8 and without the program's name. Reports every error;
/// returns the exit code.
int runProgram(const std::vector<std::string>& arguments);

}  // namespace girth::cli
