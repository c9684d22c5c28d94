#include "girth/study/write_robustness.h"

#include <cmath>

#include "text/json_text.h"
#include "text/number_text.h"
#include "write/csv_text.h"

namespace girth::study {

using io::formatNumber;
using io::jsonString;

namespace {

std::string number(double value, const char* none) {
  return std::isfinite(value) ? formatNumber(value) : std::string(none);
}

std::string number(const std::optional<double>& value, const char* none) {
  return value ? number(*value, none) : std::string(none);
}

}  // namespace

std::string robustnessCsv(std::span<const RobustnessRow> rows) {
  std::string text = "figure,change,faces,difference,unchanged,paper,note\n";
  for (const RobustnessRow& row : rows) {
    text += row.figure + "," + csvText(row.change) + "," + std::to_string(row.faces) + "," +
            number(row.difference, "") + "," + number(row.unchanged, "") + "," +
            number(row.paper, "") + "," + csvText(row.note) + "\n";
  }
  return text;
}

std::string robustnessJson(std::span<const RobustnessRow> rows, std::string_view file) {
  std::string text;
  for (const RobustnessRow& row : rows) {
    text += text.empty() ? "\n" : ",\n";
    text += "{\"figure\":" + jsonString(row.figure) + ",\"change\":" + jsonString(row.change) +
            ",\"faces\":" + std::to_string(row.faces) +
            ",\"difference\":" + number(row.difference, "null") +
            ",\"unchanged\":" + number(row.unchanged, "null") +
            ",\"paper\":" + number(row.paper, "null") + ",\"note\":" + jsonString(row.note) + "}";
  }
  return "{\"file\":" + jsonString(file) + ",\"rows\":[" + text + "]}\n";
}

}  // namespace girth::study
