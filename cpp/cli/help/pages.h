// Manual pages and completions of shells, made of the same tables as the help.
#pragma once

#include <string>
#include <vector>

namespace girth::cli {

/// A file by its place under share/, as in "man/man1/girth.1".
struct Page {
  std::string path, content;
};

/// girth(1) and a page for each command.
std::vector<Page> manualPages();

/// Completions for bash, zsh and fish, where each of them looks for them.
std::vector<Page> completionPages();

}  // namespace girth::cli
