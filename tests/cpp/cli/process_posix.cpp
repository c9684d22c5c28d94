#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <thread>

#include "process.h"

namespace girth::test {

Process startProcess(const std::string& program, const std::vector<std::string>& arguments,
                     const std::filesystem::path& folder) {
  const pid_t child = fork();
  if (child != 0) return {child};
  if (std::freopen((folder / "stdout").c_str(), "wb", stdout) == nullptr ||
      std::freopen((folder / "stderr").c_str(), "wb", stderr) == nullptr) {
    _exit(126);
  }
  std::vector<std::string> copies{program};
  copies.insert(copies.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& copy : copies) pointers.push_back(copy.data());
  pointers.push_back(nullptr);
  execv(pointers[0], pointers.data());
  _exit(127);
}

void waitUntilInterruptible(const Process& process) {
  using namespace std::chrono_literals;
  constexpr std::uint64_t kInterrupt = std::uint64_t{1} << (SIGINT - 1);
  for (int i = 0; i < 3000; ++i) {
    std::ifstream status("/proc/" + std::to_string(process.number) + "/status");
    if (!status) break;
    for (std::string line; std::getline(status, line);) {
      if (line.rfind("SigCgt:", 0) != 0) continue;
      if ((std::stoull(line.substr(7), nullptr, 16) & kInterrupt) != 0) return;
    }
    std::this_thread::sleep_for(10ms);
  }
  std::this_thread::sleep_for(500ms);
}

bool interrupt(const Process& process) { return kill(process.number, SIGINT) == 0; }

bool terminate(const Process& process) { return kill(process.number, SIGTERM) == 0; }

int endOf(const Process& process) {
  int status = 0;
  waitpid(process.number, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace girth::test
