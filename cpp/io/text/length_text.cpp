#include "text/length_text.h"

#include <cctype>
#include <optional>

#include "text/number_text.h"

namespace girth::io {
namespace {

constexpr double kGreatest = 1e300;

Error wrong(std::string_view text, const char* why, const std::string& hint) {
  Error error =
      makeError(ErrorCode::Usage, -1, "\"" + std::string(text) + "\" " + std::string(why));
  error.hint = hint;
  return error;
}

/// A number of at least 0; a comma may stand for the point.
std::optional<double> amountOf(std::string digits) {
  if (const std::size_t comma = digits.find(','); comma != std::string::npos) digits[comma] = '.';
  const std::optional<double> number = parseNumber(digits);
  return number && *number >= 0 && *number <= kGreatest ? number : std::nullopt;
}

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

std::string_view withoutSpacesAround(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// With a plain space for each of the narrow and unbreakable ones that stand before units.
std::string withPlainSpaces(std::string_view text) {
  std::string plain(text);
  for (const std::string_view space : {"\xE2\x80\xAF", "\xE2\x80\x89", "\xC2\xA0", "\t"}) {
    for (std::size_t at = 0; (at = plain.find(space, at)) != std::string::npos;) {
      plain.replace(at, space.size(), " ");
    }
  }
  return plain;
}

}  // namespace

Result<TypedLength> parseLength(std::string_view given) {
  const std::string plain = withPlainSpaces(given);
  const std::string_view text = withoutSpacesAround(plain);
  std::size_t end = text.size();
  while (end > 0 && isLetter(text[end - 1])) --end;
  const std::string_view unit = text.substr(end);
  const auto number = amountOf(std::string(withoutSpacesAround(text.substr(0, end))));
  if (!number) {
    return wrong(text, "is not a length of at least 0", "write a number, as in 3 or 3mm");
  }
  TypedLength length;
  length.number = *number;
  if (unit.empty()) return length;
  length.unit = findLengthUnit(unit);
  if (length.unit == nullptr) {
    return wrong(text, "has an unknown unit", "use " + lengthUnitWords());
  }
  return length;
}

Result<double> lengthInUnit(std::string_view text, std::string_view unit) {
  const Result<TypedLength> typed = parseLength(text);
  if (!typed) return typed.error();
  if (typed.value().unit == nullptr) return typed.value().number;
  const LengthUnit* wanted = findLengthUnit(unit);
  if (wanted == nullptr) {
    return wrong(text, "has a unit, but the model's unit is not known",
                 "give the model's unit with --unit, or leave the unit out");
  }
  return typed.value().number * typed.value().unit->metres / wanted->metres;
}

Result<double> lengthOrShare(std::string_view text, std::string_view unit, double whole) {
  const std::string plain = withPlainSpaces(text);
  std::string_view typed = withoutSpacesAround(plain);
  if (typed.empty() || typed.back() != '%') return lengthInUnit(text, unit);
  typed.remove_suffix(1);
  const auto percent = amountOf(std::string(withoutSpacesAround(typed)));
  if (!percent) {
    return wrong(text, "is not a share of at least 0%", "write a number before the sign, as in 2%");
  }
  const double length = *percent / 100 * whole;
  if (!(length <= kGreatest)) return wrong(text, "is too long", "write a smaller share");
  return length;
}

}  // namespace girth::io
