// girth: the intrinsic girth function on the command line.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "commands/command.h"
#include "girth/version.h"
#include "process/report.h"

namespace {

using namespace girth;
using namespace girth::cli;

constexpr const char* kFooter =
    "Models are glTF, GLB, OBJ, PLY, STL or OFF files. Vertices and faces are numbered as in the\n"
    "file, from 0.\n"
    "Exit codes: 0 done, 1 wrong usage, 2 bad input, 3 a limit was met or the work was cancelled,\n"
    "4 something is too thin to print.";

int run(int argc, char** argv) {
  CLI::App app{
      "The intrinsic girth function of surfaces: the length of the shortest loop that can "
      "be drawn tight around a surface through each of its points."};
  app.name("girth");
  app.footer(kFooter);
  app.set_version_flag("--version", std::string("girth ") + GIRTH_VERSION);
  const Run command = addCommands(app, allCommands());
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version come this way too.
    if (error.get_exit_code() == 0) return app.exit(error);
    const bool unknownCommand = argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty();
    return reportError("", makeError(ErrorCode::Usage, -1,
                                     unknownCommand ? "there is no command " + std::string(argv[1])
                                                    : std::string(error.what())));
  }
  return command();
}

}  // namespace

int main(int argc, char** argv) {
  int exitCode = 0;
  try {
    exitCode = run(argc, argv);
  } catch (const std::bad_alloc&) {
    exitCode = reportError("", makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory"));
  } catch (const std::exception& error) {
    exitCode = reportError("", makeError(ErrorCode::Internal, -1, error.what()));
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    const int unwritable = reportError(
        "standard output", makeError(ErrorCode::FileUnwritable, -1, "it cannot be written"));
    if (exitCode == 0) exitCode = unwritable;
  }
  return exitCode;
}
