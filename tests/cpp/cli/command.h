// The girth command as a program of its own, run in a folder of the test's.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "process.h"
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
  ~Command() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

  /// Starts the command; `wait` ends it.
  Process start(const std::vector<std::string>& arguments) const {
    return startProcess(girthCommand(), arguments, folder_);
  }

  Outcome wait(const Process& child) const {
    const int exitCode = endOf(child);
    return {exitCode, contentOf(path("stdout")), contentOf(path("stderr"))};
  }

  Outcome run(const std::vector<std::string>& arguments) const { return wait(start(arguments)); }

  fs::path folder_ = newFolder();
};

}  // namespace girth::test
