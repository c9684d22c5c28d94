// Where tests find things. Only test_paths.cpp is compiled anew in another checkout: the compiler
// cache knows the rest.
#pragma once

#include <string>

namespace girth::test {

/// The folder tests/data.
std::string testData();
/// The program `girth` of this build; empty where it is not built.
std::string girthCommand();

}  // namespace girth::test
