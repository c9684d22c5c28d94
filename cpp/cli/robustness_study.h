// `girth study robustness`
#pragma once

#include <string>
#include <vector>

#include "girth/study/robustness.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}

namespace girth::cli {

struct RobustnessStudyOptions {
  std::string model;
  std::vector<std::string> poses;
  study::RobustnessOptions study;
  /// Empty: only the table on standard output.
  std::string output;
  unsigned threads{0};
  bool json{false};
};

void addRobustnessOptions(CLI::App& command, RobustnessStudyOptions& options);

/// How little the girth changes with a surface's triangles, noise and pose.
int runRobustnessStudy(const RobustnessStudyOptions& options);

}  // namespace girth::cli
