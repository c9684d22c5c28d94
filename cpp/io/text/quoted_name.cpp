#include "text/quoted_name.h"

namespace girth::io {

std::string inQuotes(std::string_view name) {
  constexpr std::size_t kLongest = 80;
  std::string text = "\"";
  for (const char c : name.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte < 0x20 || byte == 0x7F ? '?' : c;
  }
  // A cut must not fall inside a UTF-8 sequence.
  if (name.size() > kLongest) {
    while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) {
      text.pop_back();
    }
    if (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0x80) != 0) text.pop_back();
    text += "...";
  }
  return text + "\"";
}

std::string spacedName(std::string_view name) {
  return name.empty() ? std::string() : " " + inQuotes(name);
}

}  // namespace girth::io
