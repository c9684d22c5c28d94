// girth study: the paper's studies.
#include <array>

#include "commands/table.h"

namespace girth::cli {
namespace {

Run add(CLI::App& app) {
  static constexpr std::array kStudies{&kStudyAccuracy, &kStudyRobustness};
  return addCommands(app, kStudies);
}

}  // namespace

const Command kStudy{"study", "Repeat one of the paper's studies", add};

}  // namespace girth::cli
