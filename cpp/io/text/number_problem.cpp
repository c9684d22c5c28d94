#include "text/number_problem.h"

#include "text/number_text.h"
#include "text/quoted_name.h"

namespace girth::io {
namespace {

/// Whether the commas of a word are what keeps it from being numbers.
bool hasCommas(std::string_view word) {
  bool hasComma = false;
  while (true) {
    const std::size_t comma = word.find(',');
    const std::string_view part = word.substr(0, comma);
    if (!part.empty() && !parseNumber(part)) return false;
    if (comma == std::string_view::npos) return hasComma;
    hasComma = true;
    word.remove_prefix(comma + 1);
  }
}

}  // namespace

std::string numberProblem(std::string_view word, const std::string& what) {
  return inQuotes(word) + " is " + what + (hasCommas(word) ? ": it has a comma" : "");
}

Error withNumberHint(Error error, std::string_view word) {
  if (hasCommas(word)) {
    error.hint =
        "write decimal points, and spaces between numbers: replace the commas in the file, or set "
        "the program or the system to English numbers before it exports";
  }
  return error;
}

}  // namespace girth::io
