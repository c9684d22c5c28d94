// Faults of a word that stands where a number must be.
#pragma once

#include <string>
#include <string_view>

#include "girth/error.h"

namespace girth::io {

/// The word is no number, or not what it should be. Commas are named: programs write them for
/// decimal points, or between numbers.
std::string numberProblem(std::string_view word, const std::string& what = "not a number");

/// The error, with the remedy where the word has a comma.
Error withNumberHint(Error error, std::string_view word);

}  // namespace girth::io
