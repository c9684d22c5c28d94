#include "commands/table.h"

#include <array>

namespace girth::cli {

std::span<const Command* const> allCommands() {
  static constexpr std::array kAll{&kInfo,     &kIgf,       &kLoop,       &kRemesh,  &kField,
                                   &kTips,     &kLimbs,     &kNecks,      &kHandles, &kCut,
                                   &kSection,  &kSegments,  &kBottleneck, &kProfile, &kParts,
                                   &kRetrieve, &kSignature, &kCompare,    &kStudy,   &kHelp};
  return kAll;
}

}  // namespace girth::cli
