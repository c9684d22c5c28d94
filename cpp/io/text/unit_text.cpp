#include "text/unit_text.h"

#include "girth/io/length_unit.h"
#include "text/words.h"

namespace girth::io {
namespace {

constexpr std::string_view kUnit = "unit:";
// Not "solid", with which text begins.
constexpr std::string_view kHeader = "binary STL, unit:";

/// The unit that a text names and nothing besides.
std::string unitNamed(std::string_view text) {
  Words words(text);
  const LengthUnit* unit = findLengthUnit(words.next());
  return unit == nullptr || !words.atEnd() ? std::string() : std::string(unit->name);
}

}  // namespace

std::string unitComment(std::string_view mark, std::string_view unit) {
  if (unit.empty()) return {};
  return std::string(mark) + " " + std::string(kUnit) + " " + std::string(unit) + "\n";
}

std::string unitInComments(std::string_view text, std::string_view mark) {
  constexpr std::size_t kBeginning = 4096;
  text = text.substr(0, kBeginning);
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    text.remove_prefix(line.size() == text.size() ? line.size() : line.size() + 1);
    if (!line.starts_with(mark)) continue;
    std::string_view comment = line.substr(mark.size());
    while (!comment.empty() && isBlank(comment[0])) comment.remove_prefix(1);
    if (comment.starts_with(kUnit)) return unitNamed(comment.substr(kUnit.size()));
  }
  return {};
}

std::string unitHeader(std::string_view unit) {
  return std::string(kHeader) + " " + std::string(unit.empty() ? "unknown" : unit);
}

std::string unitInHeader(std::string_view header) {
  return header.starts_with(kHeader) ? unitNamed(header.substr(kHeader.size())) : std::string();
}

}  // namespace girth::io
