#include "commands/igf/stopped.h"

#include "process/files.h"
#include "process/report.h"

namespace girth::cli::igf_command {

int reportStopped(const std::string& model, const GirthField& field, const PartialField& partial,
                  const Options& options) {
  Error error = makeError(ErrorCode::Cancelled, -1,
                          "stopped after " + std::to_string(field.computed) + " of " +
                              std::to_string(field.values.size()) + " vertices");
  error.hint = "";
  if (options.output.isFile()) {
    if (const auto problem = partial.write(field)) return reportError(partial.path(), *problem);
    error.hint = "they are kept in " + partial.path() + ", from which --resume goes on";
  }
  return reportError(model, error);
}

std::optional<Error> clearPartial(const std::string& model, const PartialField& partial,
                                  const Options& options) {
  if (!options.output.isFile() || options.resume || options.output.force ||
      !isFile(partial.path())) {
    return std::nullopt;
  }
  const auto another = partial.ofAnother();
  if (!another) {
    return usageError("a stopped run has left " + partial.path(),
                      "go on from it with --resume, or begin again with --force");
  }
  const auto name = keepAside(partial.path());
  if (!name) {
    Error error = name.error();
    error.message = partial.path() + " " + *another + "; " + error.message;
    return error;
  }
  printNote(model, partial.path() + " " + *another + ". It is kept as " + name.value());
  return std::nullopt;
}

}  // namespace girth::cli::igf_command
