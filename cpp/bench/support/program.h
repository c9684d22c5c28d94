// The frame of every program's main around its work.
#pragma once

#include <cstdio>
#include <exception>

namespace girth::bench {

/// Runs the program; says on standard error what went wrong where it throws, and ends with 1.
inline int runProgram(int (*program)(int, char**), int argc, char** argv) {
  try {
    return program(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

}  // namespace girth::bench
