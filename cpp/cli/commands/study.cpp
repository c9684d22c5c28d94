// girth study: the paper's studies.
#include <array>

#include "commands/table.h"

namespace girth::cli {
namespace {

constexpr std::array kStudies{&kStudyAccuracy, &kStudyRobustness};

}  // namespace

const Command kStudy{"study", "Repeat one of the paper's studies", nullptr, kStudies};

}  // namespace girth::cli
