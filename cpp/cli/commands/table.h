// The commands, each defined in the file of its name.
#pragma once

#include "commands/command.h"

namespace girth::cli {

extern const Command kInfo, kIgf, kLoop, kRemesh, kField, kTips, kLimbs, kNecks, kHandles, kCut,
    kSection, kSegments, kBottleneck, kProfile, kParts, kRetrieve, kSignature, kCompare, kStudy,
    kHelp;

/// Under `girth study`.
extern const Command kStudyAccuracy, kStudyRobustness;

}  // namespace girth::cli
