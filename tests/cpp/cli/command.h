// The girth command as a program of its own, run in a folder of the test's.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "test_paths.h"

namespace girth::test {

namespace fs = std::filesystem;

inline const std::string kData = testData();

inline std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

inline bool contains(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

struct Outcome {
  int exitCode;
  std::string output, errors;
};

/// A folder for the files of one test.
class Command : public ::testing::Test {
 protected:
  Command() {
    std::string name = (fs::temp_directory_path() / "girth-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~Command() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

  /// Starts the command; `wait` ends it.
  pid_t start(const std::vector<std::string>& arguments) const {
    const pid_t child = fork();
    if (child != 0) return child;
    if (std::freopen(path("stdout").c_str(), "wb", stdout) == nullptr ||
        std::freopen(path("stderr").c_str(), "wb", stderr) == nullptr) {
      _exit(126);
    }
    std::vector<std::string> copies{girthCommand()};
    copies.insert(copies.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& copy : copies) pointers.push_back(copy.data());
    pointers.push_back(nullptr);
    execv(pointers[0], pointers.data());
    _exit(127);
  }

  /// Waits until the command catches interrupts; where /proc does not show that, for half a second.
  static void waitUntilInterruptible(pid_t child) {
    using namespace std::chrono_literals;
    constexpr std::uint64_t kInterrupt = std::uint64_t{1} << (SIGINT - 1);
    for (int i = 0; i < 3000; ++i) {
      std::ifstream status("/proc/" + std::to_string(child) + "/status");
      if (!status) break;
      for (std::string line; std::getline(status, line);) {
        if (line.rfind("SigCgt:", 0) != 0) continue;
        if ((std::stoull(line.substr(7), nullptr, 16) & kInterrupt) != 0) return;
      }
      std::this_thread::sleep_for(10ms);
    }
    std::this_thread::sleep_for(500ms);
  }

  Outcome wait(pid_t child) const {
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            contentOf(path("stdout")), contentOf(path("stderr"))};
  }

  Outcome run(const std::vector<std::string>& arguments) const { return wait(start(arguments)); }

  fs::path folder_;
};

}  // namespace girth::test
