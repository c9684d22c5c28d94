#include "test_paths.h"

namespace girth::test {

std::string testData() { return GIRTH_TEST_DATA; }
std::string girthCommand() { return GIRTH_COMMAND; }

}  // namespace girth::test
