#include "test_paths.h"

#include <cstdlib>

namespace girth::test {

std::string testData() { return GIRTH_TEST_DATA; }
std::string girthCommand() { return GIRTH_COMMAND; }

std::string corpusFolder() {
  const char* folder = std::getenv("GIRTH_DATA");
  return folder == nullptr ? "" : folder;
}

}  // namespace girth::test
