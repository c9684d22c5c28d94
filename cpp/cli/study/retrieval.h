// The retrieval study: how well descriptors find shapes of the same class in a collection, with a
// report as files.
#pragma once

#include <string>
#include <vector>

#include "girth/study/signatures.h"
#include "model/model_options.h"
#include "study/comparison.h"
#include "study/shard.h"

namespace girth::cli {

struct RetrievalOptions : ComparisonOptions {
  RetrievalOptions() { signatures.axis = 0.95; }
  std::vector<std::string> folders;
  /// A class file for each folder, as far as they go.
  std::vector<std::string> classes;
  /// Preparation of every model.
  ModelOptions preparing;
  std::string output;
  /// Empty: in the output.
  std::string cache;
  /// "I/N", or empty.
  std::string shard;
  std::string title;
};

/// Computes, measures, writes the report and prints the table; of a share of the work only the
/// fields are computed. Reports errors and returns the exit code.
int runRetrieval(const RetrievalOptions& options, std::vector<study::Descriptor> descriptors,
                 const Shard& shard);

}  // namespace girth::cli
