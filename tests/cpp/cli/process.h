// Programs that tests start, interrupt and wait for: process_posix.cpp and process_windows.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace girth::test {

/// A program that runs. Its output goes to the files `stdout` and `stderr` of its folder.
struct Process {
#ifdef _WIN32
  void* handle;
  unsigned long number;
#else
  int number;
#endif
};

/// Starts a program; `endOf` ends it.
Process startProcess(const std::string& program, const std::vector<std::string>& arguments,
                     const std::filesystem::path& folder);

/// Waits until it catches interrupts; where the system does not show that, for half a second.
void waitUntilInterruptible(const Process& process);

/// Interrupts it as Ctrl-C does; whether that could be done.
bool interrupt(const Process& process);

/// Asks it to end as systems do that shut down; whether that could be done.
bool terminate(const Process& process);

/// Waits for its end; the exit code, or 128 and the number of the signal that ended it.
int endOf(const Process& process);

}  // namespace girth::test
