#include "text/html_text.h"

#include <cmath>
#include <cstddef>

namespace girth::io {

std::string escapedHtml(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string decimalText(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  const long long whole = std::llround(std::fabs(value) * scale);
  std::string text = std::to_string(whole);
  if (digits > 0) {
    const auto behind = static_cast<std::size_t>(digits);
    if (text.size() <= behind) text.insert(0, behind + 1 - text.size(), '0');
    text.insert(text.size() - behind, ".");
  }
  return (value < 0 && whole != 0 ? "-" : "") + text;
}

}  // namespace girth::io
