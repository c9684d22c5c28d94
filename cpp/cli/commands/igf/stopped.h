// Runs of `girth igf` that were stopped: what they leave, and what becomes of it.
#pragma once

#include <optional>
#include <string>

#include "commands/igf/options.h"
#include "girth/error.h"
#include "girth/girth_field.h"
#include "model/partial_field.h"

namespace girth::cli::igf_command {

/// Keeps the values of a run that was stopped. Returns the exit code.
int reportStopped(const std::string& model, const GirthField& field, const PartialField& partial,
                  const Options& options);

/// Refuses to begin over a stopped run of the same model and options, unless that is asked for;
/// what another one has left is kept under another name.
std::optional<Error> clearPartial(const std::string& model, const PartialField& partial,
                                  const Options& options);

}  // namespace girth::cli::igf_command
