#include "text/number_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "text/exact_decimal.h"

namespace girth::io {
namespace {

// Longer tokens are not numbers that anybody wrote.
constexpr std::size_t kMaxLength = 1024;

bool equalsIgnoringCase(std::string_view text, std::string_view lower) {
  if (text.size() != lower.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (std::tolower(static_cast<unsigned char>(text[i])) != lower[i]) return false;
  }
  return true;
}

__extension__ using Wide = unsigned __int128;

/// 5^0 to 5^27: all that 64 bits hold.
constexpr std::array<std::uint64_t, 28> kPowersOfFive = [] {
  std::array<std::uint64_t, 28> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 5 * powers[i - 1];
  return powers;
}();

/// `mantissa` / 10^`power`, rounded correctly; mantissa > 0, power at most 27. The quotient by
/// 5^power is taken to 63 bits or more by whole numbers; one bit records whether anything is left
/// behind them.
double dividedByPowerOfTen(std::uint64_t mantissa, int power) {
  const std::uint64_t divisor = kPowersOfFive[static_cast<std::size_t>(power)];
  const int up = std::countl_zero(mantissa), divisorUp = std::countl_zero(divisor);
  const Wide dividend = static_cast<Wide>(mantissa << up) << 63;
  const std::uint64_t shifted = divisor << divisorUp;
  const auto quotient = static_cast<std::uint64_t>(dividend / shifted);
  const bool more = static_cast<Wide>(quotient) * shifted != dividend;
  return std::ldexp(static_cast<double>(quotient | (more ? 1u : 0u)), divisorUp - up - power - 63);
}

/// Spellings of no finite number, as C libraries print it: "nan", "nan(ind)", "inf", "1.#QNAN",
/// "1.#INF00".
std::optional<double> specialNumber(std::string_view text) {
  const bool isWindows = text.starts_with("1.#");
  if (isWindows) text.remove_prefix(3);
  if (text.empty() || isDigit(text[0])) return std::nullopt;
  const bool isInfinity = equalsIgnoringCase(text.substr(0, 3), "inf");
  if (isInfinity && (isWindows || text.size() == 3 || equalsIgnoringCase(text, "infinity"))) {
    return std::numeric_limits<double>::infinity();
  }
  const bool isNan = equalsIgnoringCase(text.substr(0, 3), "nan") &&
                     (text.size() == 3 || (text[3] == '(' && text.back() == ')'));
  if (!isNan && !isWindows) return std::nullopt;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
  if (text.empty() || text.size() > kMaxLength) return std::nullopt;
  std::size_t at = 0;
  const bool negative = text[0] == '-';
  if (text[0] == '-' || text[0] == '+') ++at;

  const std::string_view magnitude = text.substr(at);
  if (const auto value = specialNumber(magnitude)) return negative ? -*value : *value;

  std::uint64_t mantissa = 0;
  int exponent = 0;
  bool anyDigit = false;
  bool mantissaFits = true;
  const auto takeDigit = [&](char c) {
    anyDigit = true;
    if (mantissa > 900000000000000000u) {
      mantissaFits = false;
    } else {
      mantissa = 10 * mantissa + static_cast<std::uint64_t>(c - '0');
    }
  };
  for (; at < text.size() && isDigit(text[at]); ++at) takeDigit(text[at]);
  if (at < text.size() && text[at] == '.') {
    for (++at; at < text.size() && isDigit(text[at]); ++at) {
      takeDigit(text[at]);
      --exponent;
    }
  }
  if (!anyDigit) return std::nullopt;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    const bool down = at < text.size() && text[at] == '-';
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
    if (at == text.size()) return std::nullopt;
    int written = 0;
    for (; at < text.size() && isDigit(text[at]); ++at) {
      if (written < 100000) written = 10 * written + (text[at] - '0');
    }
    exponent += down ? -written : written;
  }
  if (at != text.size()) return std::nullopt;

  // Both factors are exact doubles, so that one multiplication or division rounds correctly
  // (Clinger, "How to read floating point numbers accurately", 1990).
  static constexpr std::array<double, 23> powersOfTen{
      1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
      1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  if (mantissaFits && mantissa <= (std::uint64_t{1} << 53) && std::abs(exponent) <= 22) {
    const double whole = static_cast<double>(mantissa);
    const double power = powersOfTen[static_cast<std::size_t>(std::abs(exponent))];
    const double value = exponent < 0 ? whole / power : whole * power;
    return negative ? -value : value;
  }
  if (mantissaFits && mantissa == 0) return negative ? -0.0 : 0.0;
  if (mantissaFits && exponent <= 0 && exponent >= -27) {
    const double value = dividedByPowerOfTen(mantissa, -exponent);
    return negative ? -value : value;
  }
  std::string digits(magnitude.substr(0, magnitude.find_first_of("eE")));
  digits.erase(std::remove(digits.begin(), digits.end(), '.'), digits.end());
  const double value = exactDecimal(digits, exponent);
  return negative ? -value : value;
}

std::string formatNumber(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  std::string text;
  for (int digits = 15; digits <= 17; ++digits) {
    std::array<char, 40> buffer;
    const int length = std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
    text.clear();
    bool pointWritten = false;
    for (int i = 0; i < length; ++i) {
      const char c = buffer[static_cast<std::size_t>(i)];
      if (isDigit(c) || c == '-' || c == '+' || c == 'e') {
        text += c;
      } else if (!pointWritten) {
        // The locale's decimal separator, which may take several bytes.
        text += '.';
        pointWritten = true;
      }
    }
    if (parseNumber(text) == value) break;
  }
  return text;
}

std::string readableNumber(double value) {
  // The smallest number has its first digit at the 324th decimal.
  constexpr int kDigits = 6, kMostDecimals = 330;
  // From here on a number is whole and has more digits than are true of it.
  constexpr double kHuge = 1e21;
  if (value == 0 || !std::isfinite(value)) return value == 0 ? "0" : formatNumber(value);
  if (std::fabs(value) >= kHuge) {
    std::string digits = formatNumber(value);
    const std::size_t e = digits.find('e'), point = digits.find('.');
    auto zeros = static_cast<std::size_t>(std::stoi(digits.substr(e + 1)));
    digits.erase(e);
    if (point != std::string::npos) {
      zeros -= digits.size() - point - 1;
      digits.erase(point, 1);
    }
    return digits + std::string(zeros, '0');
  }
  const int power = static_cast<int>(std::floor(std::log10(std::fabs(value))));
  const int decimals = std::clamp(kDigits - 1 - power, 0, kMostDecimals);
  std::array<char, 400> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  std::string text = buffer.data();
  // Whatever the process's locale has between the digits.
  const std::size_t point = text.find_first_not_of("-0123456789");
  if (point == std::string::npos) return text;
  text.replace(point, text.find_first_of("0123456789", point) - point, ".");
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace girth::io
