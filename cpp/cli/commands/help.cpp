// girth help: the help of a command, by its words.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/table.h"
#include "files/write_file.h"
#include "help/pages.h"
#include "process/files.h"
#include "process/report.h"

namespace girth::cli {
namespace help_command {
namespace {

struct Options {
  std::vector<std::string> words;
  /// The folder to write manual pages and completions into; empty: none.
  std::string pages;
};

int writePages(const std::string& folder) {
  std::vector<Page> pages = manualPages();
  for (Page& page : completionPages()) pages.push_back(std::move(page));
  for (const Page& page : pages) {
    const std::string path = folder + "/" + page.path;
    if (const auto error = makeFolderOf(path)) return reportError(path, *error);
    if (const auto error = io::writeFile(path, page.content)) return reportError(path, *error);
  }
  return 0;
}

int run(const Options& options) {
  if (!options.pages.empty()) return writePages(options.pages);
  std::vector<std::string> words = options.words;
  words.emplace_back("--help");
  return runCommandLine(words);
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("COMMAND", options->words,
            "A command, such as igf or study robustness; none: all commands");
  table.add("--pages DIR", options->pages,
            "Write manual pages and completions (bash, zsh, fish) into this folder, laid out like "
            "share/");
  table.example("girth help igf", "The options and examples of girth igf.");
  table.example("girth help study robustness", "The options of a command within another.");
  table.example("girth help --pages ~/.local/share", "Manual pages and completions for yourself.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace help_command

const Command kHelp{"help", "Print the options and examples of a command", help_command::add};

}  // namespace girth::cli
