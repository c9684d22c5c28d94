// How a command ends: its result as a file, as JSON on standard output, or in words.
#pragma once

#include <cstdio>

#include "process/output.h"
#include "process/report.h"

namespace girth::cli {

/// Writes the result where a file is wanted, and prints it as JSON or, where there is a summary, in
/// words. `contentFor(ending)`: what the file has, or an error. Returns the exit code.
template <class ContentFor, class Json, class PrintText>
int handOver(const Output& output, bool isJson, ContentFor contentFor, Json json,
             PrintText printText) {
  if (output.isWanted()) {
    if (auto error = writeResult(output, contentFor(output.ending()))) {
      return reportError(output.path, *error);
    }
  }
  if (isJson) {
    std::fputs(json().c_str(), stdout);
  } else if (hasSummary()) {
    printText();
  }
  return 0;
}

}  // namespace girth::cli
