#include "test_paths.h"

#include <cstdlib>

namespace girth::test {

std::string testData() { return GIRTH_TEST_DATA; }
std::string girthCommand() { return GIRTH_COMMAND; }

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
