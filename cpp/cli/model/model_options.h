// How a model is prepared: the options that most commands share.
#pragma once

#include <string>
#include <vector>

#include "cli_app.h"

namespace girth::cli {

struct ModelOptions {
  /// Also weld vertices no farther apart than this, with or without a unit behind it.
  std::string weldDistance;
  bool closeHoles{false};
  /// Components to keep, by their numbers in `girth info`, or "largest"; empty: all.
  std::vector<std::string> components;
  /// What the numbers of the file are; empty: as the file says.
  std::string unit;
};

/// Adds `--weld`, `--close-holes`, `--component` and `--unit`.
void addModelOptions(CLI::App& app, ModelOptions& options);

}  // namespace girth::cli
