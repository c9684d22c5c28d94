// Text as a field of CSV.
#pragma once

#include <string>

namespace girth::study {

/// The text, in quotation marks where it has a comma, a quotation mark or an end of line in it.
inline std::string csvText(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') quoted += '"';
  }
  return quoted + "\"";
}

}  // namespace girth::study
