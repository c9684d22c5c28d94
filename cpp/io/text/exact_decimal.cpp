#include "text/exact_decimal.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace girth::io {
namespace {

/// A whole number ≥ 0 in limbs of 32 bits, the lowest first.
using Limbs = std::vector<std::uint32_t>;

constexpr std::uint32_t kPowersOfTen[] = {
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000};
constexpr int kLimbDigits = 9;

void multiplyAdd(Limbs& limbs, std::uint32_t factor, std::uint32_t summand) {
  std::uint64_t carry = summand;
  for (std::uint32_t& limb : limbs) {
    carry += std::uint64_t{limb} * factor;
    limb = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  if (carry != 0) limbs.push_back(static_cast<std::uint32_t>(carry));
}

/// Divides, rounding down; the remainder.
std::uint32_t divide(Limbs& limbs, std::uint32_t divisor) {
  std::uint64_t rest = 0;
  for (std::size_t i = limbs.size(); i-- > 0;) {
    rest = rest << 32 | limbs[i];
    limbs[i] = static_cast<std::uint32_t>(rest / divisor);
    rest %= divisor;
  }
  while (!limbs.empty() && limbs.back() == 0) limbs.pop_back();
  return static_cast<std::uint32_t>(rest);
}

/// (`mantissa` + a rest below 1, where there is `more`) · 2^`power`, rounded; the mantissa's
/// highest bit is set.
double rounded(std::uint64_t mantissa, bool more, int power) {
  // 53 bits, fewer for numbers that are not normal.
  const int dropped = std::max(11, -1074 - power);
  if (dropped > 64) return 0;
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  std::uint64_t kept = dropped == 64 ? 0 : mantissa >> dropped;
  const std::uint64_t rest = mantissa & (half - 1 + half);
  if (rest > half || (rest == half && (more || kept % 2 == 1))) ++kept;
  return std::ldexp(static_cast<double>(kept), power + dropped);
}

}  // namespace

double exactDecimal(std::string_view digits, int exponent) {
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  const int places = static_cast<int>(digits.size()) + exponent;
  if (digits.empty() || places < -325) return 0;
  if (places > 310) return std::numeric_limits<double>::infinity();

  Limbs limbs;
  for (std::size_t at = 0; at < digits.size(); at += kLimbDigits) {
    const std::string_view group = digits.substr(at, kLimbDigits);
    std::uint32_t value = 0;
    for (const char digit : group) value = 10 * value + static_cast<std::uint32_t>(digit - '0');
    multiplyAdd(limbs, kPowersOfTen[group.size()], value);
  }
  for (; exponent > 0; exponent -= std::min(exponent, kLimbDigits)) {
    multiplyAdd(limbs, kPowersOfTen[std::min(exponent, kLimbDigits)], 0);
  }
  // Limbs below the point: a digit takes away less than four bits, and 64 are to stay.
  int power = 0;
  bool more = false;
  if (exponent < 0) {
    const std::size_t below = static_cast<std::size_t>(-exponent) / 8 + 3;
    limbs.insert(limbs.begin(), below, 0);
    power = -32 * static_cast<int>(below);
  }
  for (; exponent < 0; exponent += std::min(-exponent, kLimbDigits)) {
    if (divide(limbs, kPowersOfTen[std::min(-exponent, kLimbDigits)]) != 0) more = true;
  }

  // The highest 64 bits; what lies below them counts only where it is something.
  std::uint64_t mantissa = 0;
  for (int taken = 0; taken < 2; ++taken) {
    const std::uint32_t limb = limbs.empty() ? 0 : limbs.back();
    mantissa = mantissa << 32 | limb;
    if (limbs.empty()) {
      power -= 32;
    } else {
      limbs.pop_back();
    }
  }
  const int up = std::countl_zero(mantissa);
  mantissa <<= up;
  if (!limbs.empty()) {
    if (up > 0) mantissa |= limbs.back() >> (32 - up);
    limbs.back() = up > 0 ? limbs.back() << up : limbs.back();
  }
  more =
      more || std::any_of(limbs.begin(), limbs.end(), [](std::uint32_t limb) { return limb != 0; });
  return rounded(mantissa, more, power + 32 * static_cast<int>(limbs.size()) - up);
}

}  // namespace girth::io
