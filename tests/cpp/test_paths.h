// Where tests find things. Only test_paths.cpp is compiled anew in another checkout: the compiler
// cache knows the rest.
#pragma once

#include <filesystem>
#include <string>

namespace girth::test {

/// The folder tests/data.
std::string testData();
/// The program `girth` of this build; empty where it is not built.
std::string girthCommand();
/// A new, empty folder; the test removes it.
std::filesystem::path newFolder();
/// A text as one word of a shell's line: folders may have blanks and quotes in their names.
std::string quoted(const std::string& text);
/// The folder of models from outside the repository that the environment variable GIRTH_DATA names;
/// empty where it is not set, or set to nothing.
std::string corpusFolder();

}  // namespace girth::test
