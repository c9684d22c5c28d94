#include "process/output.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "files/path_of.h"
#include "files/write_file.h"
#include "process/files.h"
#include "process/report.h"
#include "text/ending.h"

namespace girth::cli {
namespace {

std::string listed(const std::vector<std::string>& words, const char* prefix = "") {
  std::string text;
  for (const std::string& word : words) {
    text += text.empty() ? "" : &word == &words.back() ? " or " : ", ";
    text += prefix + word;
  }
  return text;
}

std::vector<std::string> formatsOf(const std::vector<std::string>& endings) {
  std::vector<std::string> formats;
  for (const std::string& ending : endings) formats.push_back(ending.substr(1));
  return formats;
}

}  // namespace

bool Output::isStandardOutput() const {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1";
}

bool Output::isFolder() const {
  std::error_code ignored;
  return isWanted() &&
         (path.back() == '/' || std::filesystem::is_directory(io::pathOf(path), ignored));
}

bool Output::isFile() const { return isWanted() && !isStandardOutput() && isOrdinary(path); }

std::string Output::ending() const { return format.empty() ? io::endingOf(path) : "." + format; }

Option& addOutputOptions(OptionTable& table, Output& output, std::vector<std::string> endings,
                         std::string text) {
  output.endings = std::move(endings);
  Option& option = table.add("-o,--output FILE", output.path, std::move(text));
  table
      .add("--format FORMAT", output.format,
           "Format to write, where the output's name has no ending, as standard output, -o -, has "
           "none: " +
               listed(formatsOf(output.endings)))
      .oneOf(formatsOf(output.endings))
      .needs("--output");
  table
      .add("--force", output.force,
           "Let the output replace the model, or the file of a stopped run")
      .needs("--output");
  return option;
}

std::optional<Error> checkOutput(const Output& output, std::span<const std::string> inputs,
                                 bool isPrinting) {
  if (!output.isWanted()) return std::nullopt;
  const auto& endings = output.endings;
  if (std::find(endings.begin(), endings.end(), output.ending()) == endings.end()) {
    if (output.isStandardOutput()) {
      return usageError("the format for standard output is missing",
                        "add --format " + listed(formatsOf(endings)));
    }
    return usageError("the output's name has no known ending",
                      "use " + listed(endings) + ", or name one with --format");
  }
  if (output.isStandardOutput()) {
    if (isPrinting) {
      return usageError("--json and -o - would both write to standard output",
                        "leave one of them out, or write the result to a file");
    }
    leaveOutSummary();
    return std::nullopt;
  }
  for (const std::string& input : inputs) {
    if (output.force || !isSameFile(input, output.path)) continue;
    return usageError("it would replace the model that is read",
                      "name another file, or add --force");
  }
  return io::checkWritable(output.path);
}

std::string pathInFolder(const std::string& folder, const std::string& model,
                         const std::string& ending) {
  std::filesystem::path name = io::pathOf(model).filename();
  if (io::endingOf(name.string()) == ".gz") name = name.stem();
  return (io::pathOf(folder) / name.replace_extension(ending)).string();
}

std::optional<Error> writeOutput(const Output& output, std::string_view content) {
  if (!output.isStandardOutput()) return io::writeFile(output.path, content);
  if (std::fwrite(content.data(), 1, content.size(), stdout) == content.size()) return std::nullopt;
  return makeError(ErrorCode::FileUnwritable, -1,
                   std::string("it cannot be written: ") + std::strerror(errno));
}

std::optional<Error> writeResult(const Output& output, const Result<std::string>& content) {
  if (!content) return content.error();
  return writeOutput(output, content.value());
}

}  // namespace girth::cli
