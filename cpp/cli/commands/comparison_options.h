// The options of all commands that compare shapes.
#pragma once

#include "options/option_table.h"
#include "study/comparison.h"

namespace girth::cli {

/// Adds --descriptors, --faces and so on.
void addComparisonOptions(OptionTable& table, ComparisonOptions& options);

}  // namespace girth::cli
