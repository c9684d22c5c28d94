// What `girth study` lets one choose.
#pragma once

#include <string>
#include <vector>

#include "girth/surface_mesh.h"
#include "robustness_study.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}

namespace girth::cli {

/// `girth study accuracy`
struct AccuracyOptions {
  std::vector<std::string> models;
  Index faces{0};
  unsigned threads{0};
};

/// Everything that can be studied.
struct StudyOptions {
  AccuracyOptions accuracy;
  RobustnessStudyOptions robustness;
};

/// Adds the studies to the command group `study`.
void addStudyOptions(CLI::App& group, StudyOptions& options);

/// Runs the study that was parsed.
int runStudy(const CLI::App& group, const StudyOptions& options);

/// How near the girth by fast marching (IGF-MS) is to the exact one.
int runAccuracyStudy(const AccuracyOptions& options);

}  // namespace girth::cli
