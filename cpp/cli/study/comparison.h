// How shapes are compared, and the fields of a single model that is.
#pragma once

#include <string>
#include <vector>

#include "girth/execution.h"
#include "girth/study/signatures.h"
#include "girth/study/study_fields.h"

namespace girth::cli {

struct ComparisonOptions {
  /// Names and sums; empty: the command's own choice.
  std::vector<std::string> descriptors;
  study::FieldParameters fields;
  study::SignatureOptions signatures;
  unsigned threads{0};
};

/// Errors: those of study::parseDescriptor.
Result<std::vector<study::Descriptor>> parseDescriptors(const std::vector<std::string>& names);

/// The fields of one surface that the descriptors are made of. Errors: those of
/// study::studyFields.
Result<study::StudyFields> comparedFields(const SurfaceMesh& mesh,
                                          const std::vector<study::Descriptor>& descriptors,
                                          const ComparisonOptions& options,
                                          const ExecutionContext& context);

}  // namespace girth::cli
