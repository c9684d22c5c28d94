// The subcommands. Each returns the exit code: 0 done, 1 usage, 2 bad input, 3 limit or cancelled.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "girth/girth_field.h"

namespace girth::cli {

struct InfoOptions {
  std::vector<std::string> models;
  bool json{false};
};

/// Says what a model is, and whether it is a surface.
int runInfo(const InfoOptions& options);

struct IgfOptions {
  std::vector<std::string> models;
  /// Empty: only a summary.
  std::string output;
  GirthMethod method{GirthMethod::Exact};
  unsigned threads{0};
  bool json{false};
  bool stats{false};
};

/// Computes the girth at all vertices.
int runIgf(const IgfOptions& options);

struct LoopOptions {
  std::string model;
  /// In the file's numbering, from 0.
  std::int64_t vertex{0};
  std::string output;
  bool json{false};
};

/// Computes the loop at one vertex.
int runLoop(const LoopOptions& options);

}  // namespace girth::cli
