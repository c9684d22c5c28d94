#include "length_text.h"

#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

#include "girth/io/number_text.h"

namespace girth::cli {
namespace {

struct UnitName {
  std::string_view shortName, name;
  double metres;
};

constexpr std::array<UnitName, 7> kUnits{{{"um", "micrometre", 1e-6},
                                          {"mm", "millimetre", 1e-3},
                                          {"cm", "centimetre", 1e-2},
                                          {"m", "metre", 1},
                                          {"km", "kilometre", 1e3},
                                          {"in", "inch", 0.0254},
                                          {"ft", "foot", 0.3048}}};

Error wrong(const std::string& text, const std::string& why, const std::string& hint) {
  Error error = makeError(ErrorCode::Usage, -1, "\"" + text + "\" " + why);
  error.hint = hint;
  return error;
}

}  // namespace

Result<double> lengthInModelUnit(const std::string& text, const std::string& modelUnit) {
  std::size_t end = text.size();
  while (end > 0 && std::isalpha(static_cast<unsigned char>(text[end - 1])) != 0) --end;
  std::string unit = text.substr(end);
  while (end > 0 && text[end - 1] == ' ') --end;
  const std::optional<double> number = io::parseNumber(text.substr(0, end));
  if (!number || !(*number >= 0) || *number > 1e300) {
    return wrong(text, "is not a length of at least 0", "write a number, as in 3 or 3mm");
  }
  if (unit.empty()) return *number;
  double typed = 0, model = 0;
  for (const UnitName& known : kUnits) {
    if (known.shortName == unit || known.name == unit) typed = known.metres;
    if (known.name == modelUnit) model = known.metres;
  }
  if (typed == 0) return wrong(text, "has an unknown unit", "use um, mm, cm, m, km, in or ft");
  if (model == 0) {
    return wrong(text, "has a unit, but the model's unit is not known",
                 "say what its numbers are with --unit, or leave the unit out");
  }
  return *number * typed / model;
}

}  // namespace girth::cli
