// What the commands that compare shapes let one choose.
#pragma once

#include <string>
#include <vector>

#include "girth/study/signatures.h"
#include "girth/study/study_fields.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}

namespace girth::cli {

/// How shapes are compared.
struct ComparisonOptions {
  /// Names and sums; empty: all names.
  std::vector<std::string> descriptors;
  study::FieldParameters fields;
  study::SignatureOptions signatures;
  unsigned threads{0};
};

struct RetrieveOptions : ComparisonOptions {
  RetrieveOptions() { signatures.axis = 0.95; }
  std::vector<std::string> folders;
  /// A class file for each folder, as far as they go.
  std::vector<std::string> classes;
  std::string output;
  /// Empty: in the output.
  std::string cache;
  /// "I/N", or empty.
  std::string shard;
  std::string title;
};

/// Adds --descriptors, --faces and so on.
void addComparisonOptions(CLI::App& command, ComparisonOptions& options);

/// Adds all options of `girth retrieve`.
void addRetrieveOptions(CLI::App& command, RetrieveOptions& options);

}  // namespace girth::cli
