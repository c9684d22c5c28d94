// girth: the intrinsic girth function on the command line.
#include "program.h"

int main(int argc, char** argv) {
  return girth::cli::runProgram({argv + (argc > 0 ? 1 : 0), argv + argc});
}
