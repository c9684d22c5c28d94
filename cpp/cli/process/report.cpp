#include "process/report.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "girth/io/length_unit.h"

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

std::string formatted(const char* format, double value) {
  std::array<char, 64> buffer;
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
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
  return exitCodeOf(error.code);
}

std::string readable(double value) { return formatted("%.6g", value); }

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
