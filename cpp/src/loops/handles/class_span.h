// Classes of closed curves, modulo 2, and what sums of them give.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "loops/handles/homology.h"

namespace girth::loops {

/// All sums, modulo 2, of some classes that are independent.
class ClassSpan {
 public:
  /// Adds a class that is no such sum: the first place in which it differs from all of them.
  /// Nothing where it is one. O(size · rank / 64).
  std::optional<std::size_t> add(const HomologyClass& c) {
    std::vector<std::uint64_t> bits((c.size() + 63) / 64, 0);
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (c[i] % 2 != 0) bits[i / 64] |= std::uint64_t{1} << (i % 64);
    }
    for (const auto& [place, row] : rows_) {
      if ((bits[place / 64] >> (place % 64) & 1) == 0) continue;
      for (std::size_t i = 0; i < bits.size(); ++i) bits[i] ^= row[i];
    }
    for (std::size_t i = 0; i < bits.size(); ++i) {
      if (bits[i] == 0) continue;
      const std::size_t place = 64 * i + static_cast<std::size_t>(std::countr_zero(bits[i]));
      rows_.emplace_back(place, std::move(bits));
      return place;
    }
    return std::nullopt;
  }
  std::size_t size() const { return rows_.size(); }

 private:
  std::vector<std::pair<std::size_t, std::vector<std::uint64_t>>> rows_;
};

}  // namespace girth::loops
