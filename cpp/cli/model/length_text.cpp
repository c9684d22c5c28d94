#include "model/length_text.h"

#include <cctype>
#include <optional>

#include "girth/io/length_unit.h"
#include "process/report.h"
#include "text/number_text.h"

namespace girth::cli {
namespace {

Error wrong(const std::string& text, const std::string& why, const std::string& hint) {
  return usageError("\"" + text + "\" " + why, hint);
}

}  // namespace

Result<double> lengthInModelUnit(const std::string& text, const std::string& modelUnit) {
  std::size_t end = text.size();
  while (end > 0 && std::isalpha(static_cast<unsigned char>(text[end - 1])) != 0) --end;
  const std::string unit = text.substr(end);
  while (end > 0 && text[end - 1] == ' ') --end;
  const std::optional<double> number = io::parseNumber(text.substr(0, end));
  if (!number || !(*number >= 0) || *number > 1e300) {
    return wrong(text, "is not a length of at least 0", "write a number, as in 3 or 3mm");
  }
  if (unit.empty()) return *number;
  const io::LengthUnit* typed = io::findLengthUnit(unit);
  const io::LengthUnit* model = io::findLengthUnit(modelUnit);
  if (typed == nullptr) {
    return wrong(text, "has an unknown unit", "use um, mm, cm, m, km, in or ft");
  }
  if (model == nullptr) {
    return wrong(text, "has a unit, but the model's unit is not known",
                 "give the model's unit with --unit, or leave the unit out");
  }
  return *number * typed->metres / model->metres;
}

}  // namespace girth::cli
