#include "text/passed_text.h"

#include "text/quoted_name.h"

namespace girth::io {

void PassedText::add(std::string_view word, std::int64_t line) {
  if (lines_ == 0) {
    firstLine_ = line;
    firstWord_ = inQuotes(word);
  }
  if (lines_ == 0 || line != lastLine_) ++lines_;
  lastLine_ = line;
}

std::string PassedText::note() const {
  const std::string first = "line " + std::to_string(firstLine_);
  if (lines_ == 1) return "Extra text on " + first + " was passed over: " + firstWord_ + ".";
  return "Extra text on " + std::to_string(lines_) + " lines was passed over, first " + firstWord_ +
         " on " + first + ".";
}

}  // namespace girth::io
