// How a command reads and prepares its model: the options that most commands share.
#pragma once

#include <string>
#include <vector>

#include "girth/io/read_mesh.h"

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

/// Reads and prepares a model. Errors: those of readFile and io::readMesh, USAGE.
Result<io::LoadedMesh> loadModel(const std::string& path, const ModelOptions& options);

}  // namespace girth::cli
