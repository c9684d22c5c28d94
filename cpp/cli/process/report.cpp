#include "process/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "girth/io/json_text.h"
#include "girth/io/length_unit.h"
#include "text/number_text.h"

namespace girth::cli {
namespace {

/// The text on one line, whatever a file's name contains.
std::string onOneLine(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return line;
}

bool quiet = false;
bool summary = true;
bool errorsAsJson = false;

std::string formatted(const char* format, double value) {
  std::array<char, 64> buffer;
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

std::string errorJson(const std::string& file, const Error& error) {
  io::JsonObject about, line;
  if (!file.empty()) line.add("file", file);
  about.add("code", toString(error.code))
      .addJson("element", error.element < 0 ? "null" : std::to_string(error.element))
      .add("message", error.message)
      .add("hint", error.hint);
  return line.addJson("error", about.text()).text() + "\n";
}

}  // namespace

Error usageError(const std::string& what, const std::string& hint) {
  Error error = makeError(ErrorCode::Usage, -1, what);
  error.hint = hint;
  return error;
}

int reportError(const std::string& file, const Error& error) {
  std::string line = "girth: ";
  if (!file.empty()) line += file + ": ";
  line += std::string(toString(error.code)) + ": " + error.message;
  if (!error.hint.empty()) line += "; " + error.hint;
  line = onOneLine(line) + "\n";
  std::fputs(line.c_str(), stderr);
  if (errorsAsJson) std::fputs(errorJson(file, error).c_str(), stdout);
  return exitCodeOf(error.code);
}

void printErrorsAsJson() { errorsAsJson = true; }

void beQuiet() { quiet = true; }

bool isQuiet() { return quiet; }

void leaveOutSummary() { summary = false; }

bool hasSummary() { return summary && !quiet; }

void printNote(const std::string& file, const std::string& text) {
  if (!quiet)
    std::fputs(
        (onOneLine("girth: " + (file.empty() ? "" : file + ": ") + "note: " + text) + "\n").c_str(),
        stderr);
}

std::string readable(double value) { return io::readableNumber(value); }

std::string readableOrDash(double value) { return std::isnan(value) ? "-" : readable(value); }

std::string readableTime(double seconds) {
  if (seconds < 10) return formatted("%.2f s", seconds);
  if (seconds < 60) return formatted("%.0f s", seconds);
  const double minutes = std::floor(seconds / 60);
  return formatted("%.0f min ", minutes) + formatted("%.0f s", std::floor(seconds - 60 * minutes));
}

std::string unitSuffix(const std::string& unit) {
  const io::LengthUnit* known = io::findLengthUnit(unit);
  return known == nullptr ? "" : " " + std::string(known->symbol);
}

std::string areaSuffix(const std::string& unit) {
  const std::string suffix = unitSuffix(unit);
  return suffix.empty() ? "" : suffix + "²";
}

void printUnits(const std::string& unit) {
  if (unitSuffix(unit).empty()) return;
  std::printf("  lengths in%s, areas in%s\n", unitSuffix(unit).c_str(), areaSuffix(unit).c_str());
}

}  // namespace girth::cli
