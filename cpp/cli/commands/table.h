// The commands, each defined in the file of its name.
#pragma once

#include "commands/command.h"

namespace girth::cli {

extern const Command kInfo, kIgf, kLoop, kRemesh, kField, kTips, kParts, kRetrieve, kSignature,
    kCompare, kStudy;

/// Under `girth study`.
extern const Command kStudyAccuracy, kStudyRobustness;

}  // namespace girth::cli
