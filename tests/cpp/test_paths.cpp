#include "test_paths.h"

#include <cstdlib>
#include <random>

namespace girth::test {

std::string testData() { return GIRTH_TEST_DATA; }
std::string girthCommand() { return GIRTH_COMMAND; }

std::filesystem::path newFolder() {
  std::random_device random;
  for (;;) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("girth-" + std::to_string(random()));
    if (std::filesystem::create_directory(folder)) return folder;
  }
}

std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string corpusFolder() {
  const char* folder = std::getenv("GIRTH_DATA");
  return folder == nullptr ? "" : folder;
}

}  // namespace girth::test
