// The command on Windows: its words are UTF-16 there, and standard streams would change line ends.
#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <cstdio>
#include <filesystem>

#include "program.h"

extern "C" {

/// Patterns such as *.obj become the files that they mean, which shells do elsewhere.
extern int _dowildcard;
int _dowildcard = -1;

int wmain(int argc, wchar_t** argv) {
  for (std::FILE* stream : {stdin, stdout, stderr}) _setmode(_fileno(stream), _O_BINARY);
  const UINT before = GetConsoleOutputCP();
  SetConsoleOutputCP(CP_UTF8);
  std::vector<std::string> arguments;
  for (int i = 1; i < argc; ++i) arguments.push_back(std::filesystem::path(argv[i]).string());
  const int exitCode = girth::cli::runProgram(arguments);
  if (before != 0) SetConsoleOutputCP(before);
  return exitCode;
}
}
