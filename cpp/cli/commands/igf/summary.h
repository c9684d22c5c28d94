// The summary of `girth igf`: in words, or as JSON.
#pragma once

#include "commands/igf/options.h"
#include "girth/girth_field.h"

namespace girth::cli::igf_command {

/// In seconds.
struct Timing {
  double reading{0}, computing{0};
};

void printJson(const Work& work, const GirthField& field, const Options& options,
               const Timing& timing);
void printText(const Work& work, const GirthField& field, const Options& options,
               const Timing& timing);

}  // namespace girth::cli::igf_command
