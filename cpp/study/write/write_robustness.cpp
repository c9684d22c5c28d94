#include "girth/study/write_robustness.h"

#include <cmath>
#include <limits>

#include "girth/io/json_text.h"
#include "text/number_text.h"
#include "write/csv_text.h"

namespace girth::study {

using io::formatNumber;
using io::JsonList;
using io::JsonObject;

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// Empty where there is none.
std::string cellOf(double value) { return std::isfinite(value) ? formatNumber(value) : ""; }

}  // namespace

std::string robustnessCsv(std::span<const RobustnessRow> rows) {
  std::string text = "figure,change,faces,difference,unchanged,paper,note\n";
  for (const RobustnessRow& row : rows) {
    text += row.figure + "," + csvText(row.change) + "," + std::to_string(row.faces) + "," +
            cellOf(row.difference) + "," + cellOf(row.unchanged.value_or(kNoNumber)) + "," +
            cellOf(row.paper.value_or(kNoNumber)) + "," + csvText(row.note) + "\n";
  }
  return text;
}

std::string robustnessJson(std::span<const RobustnessRow> rows, std::string_view file) {
  JsonList list(true);
  for (const RobustnessRow& row : rows) {
    list.add(JsonObject()
                 .add("figure", row.figure)
                 .add("change", row.change)
                 .add("faces", row.faces)
                 .add("difference", row.difference)
                 .add("unchanged", row.unchanged.value_or(kNoNumber))
                 .add("paper", row.paper.value_or(kNoNumber))
                 .add("note", row.note)
                 .text());
  }
  return JsonObject().add("file", file).addJson("rows", list.text()).text() + "\n";
}

}  // namespace girth::study
