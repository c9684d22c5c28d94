// A set of small whole numbers whose least one is found at once.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "girth/elements.h"

namespace girth::loops {

/// Bits in levels: a bit of a level says whether 64 of the one below have any. Every call is
/// O(log n), by 64.
class IndexSet {
 public:
  /// For numbers below `size`, which may grow.
  void fit(std::size_t size) {
    for (std::size_t level = 0, words = wordsFor(size);; ++level, words = wordsFor(words)) {
      if (level == levels_.size()) {
        levels_.emplace_back();
        if (level > 0 && !levels_[level - 1].empty()) {
          levels_[level].push_back(levels_[level - 1][0] != 0 ? 1 : 0);
        }
      }
      if (levels_[level].size() < words) levels_[level].resize(words, 0);
      if (words <= 1) return;
    }
  }
  bool empty() const { return levels_.empty() || levels_.back()[0] == 0; }
  /// Not of an empty set.
  Index least() const {
    std::size_t word = 0;
    for (std::size_t level = levels_.size(); level-- > 0;) {
      word = 64 * word + static_cast<std::size_t>(std::countr_zero(levels_[level][word]));
    }
    return static_cast<Index>(word);
  }
  void insert(Index number) {
    std::size_t place = number;
    for (auto& level : levels_) {
      level[place / 64] |= std::uint64_t{1} << (place % 64);
      place /= 64;
    }
  }
  void erase(Index number) {
    std::size_t place = number;
    for (auto& level : levels_) {
      level[place / 64] &= ~(std::uint64_t{1} << (place % 64));
      if (level[place / 64] != 0) return;
      place /= 64;
    }
  }

 private:
  static std::size_t wordsFor(std::size_t bits) { return (bits + 63) / 64; }

  std::vector<std::vector<std::uint64_t>> levels_;
};

}  // namespace girth::loops
