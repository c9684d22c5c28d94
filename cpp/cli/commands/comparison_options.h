// The options of all commands that compare shapes.
#pragma once

#include "cli_app.h"
#include "study/comparison.h"

namespace girth::cli {

/// Adds --descriptors, --faces and so on.
void addComparisonOptions(CLI::App& app, ComparisonOptions& options);

}  // namespace girth::cli
