// Where a command's result goes: `-o FILE`, `-o - --format csv`, and `--force`.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "options/option_table.h"

namespace girth::cli {

struct Output {
  /// Empty: nowhere; "-": standard output.
  std::string path;
  /// "csv", where it was typed; otherwise the name's ending is meant.
  std::string format;
  /// Whether even the model itself may be replaced.
  bool force{false};
  /// Endings that can be written: ".csv", ...
  std::vector<std::string> endings;

  bool isWanted() const { return !path.empty(); }
  bool isStandardOutput() const;
  /// Whether it names a folder: one that is there, or with a slash at its end.
  bool isFolder() const;
  /// Whether it is a file that stays, and neither a pipe nor a device.
  bool isFile() const;
  /// The ending of the output: ".csv".
  std::string ending() const;
};

/// Adds `-o,--output FILE`, `--format` and `--force`. Returns the first of them.
Option& addOutputOptions(OptionTable& table, Output& output, std::vector<std::string> endings,
                         std::string text);

/// Checks before long work that the result can be written: in a known format, to a place that can
/// be written, over none of the files that are read, and not to standard output with something
/// else. `isPrinting`: whether the command prints a result to standard output, as with `--json`.
/// Where the result goes to standard output, there is no summary from now on. Errors: USAGE,
/// FILE_UNWRITABLE.
std::optional<Error> checkOutput(const Output& output, std::span<const std::string> inputs,
                                 bool isPrinting);

/// Where the result of one of several models goes: "values/chair.csv" for "models/chair.off".
std::string pathInFolder(const std::string& folder, const std::string& model,
                         const std::string& ending);

/// Writes the result. Error: FILE_UNWRITABLE.
std::optional<Error> writeOutput(const Output& output, std::string_view content);

/// Writes the result if there is one. Errors: its own; FILE_UNWRITABLE.
std::optional<Error> writeResult(const Output& output, const Result<std::string>& content);

}  // namespace girth::cli
