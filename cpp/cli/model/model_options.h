// How a model is prepared: the options that most commands share.
#pragma once

#include <string>
#include <vector>

#include "cli_app.h"

namespace girth::cli {

struct ModelOptions {
  /// A length, with or without a unit: vertices no farther apart are also welded. Empty: none.
  std::string weldDistance;
  bool closeHoles{false};
  /// Components to keep, by their numbers in `girth info`, or "largest"; empty: all.
  std::vector<std::string> components;
  /// The unit of the file's numbers, as a symbol such as "mm". Empty: the one the file states.
  std::string unit;
};

/// Adds `--weld`, `--close-holes`, `--component` and `--unit`.
void addModelOptions(CLI::App& app, ModelOptions& options);

}  // namespace girth::cli
