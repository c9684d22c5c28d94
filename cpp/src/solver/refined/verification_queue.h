// The bases whose girth is still to be verified on a large surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "girth/surface_mesh.h"
#include "solver/refined/base_graph.h"

namespace girth {

/// A base stands in it at most once. The bases with the shortest loops come first: they cost least.
class VerificationQueue {
 public:
  explicit VerificationQueue(std::size_t bases) : isQueued_(bases, false), isNear_(bases, false) {}

  bool empty() const { return queue_.empty(); }

  /// `length`: of the loop that is known at the base. NaN: none is known; the base comes last.
  void add(Index base, double length) {
    if (isQueued_[base]) return;
    isQueued_[base] = true;
    queue_.emplace(std::isnan(length) ? std::numeric_limits<double>::infinity() : length, base);
  }

  /// Takes up to `most` bases for which `isOpen(base)`. No two of them lie within two edges of each
  /// other: the answer to one may settle its neighbours, which stay in the queue.
  template <class IsOpen>
  std::vector<Index> take(std::size_t most, const BaseGraph& graph, IsOpen isOpen) {
    constexpr std::size_t kMostLeft = 8;  // for each that is taken
    std::vector<Index> taken, near;
    std::vector<Item> left;
    while (!queue_.empty() && taken.size() < most && left.size() < kMostLeft * most) {
      const Item item = queue_.top();
      queue_.pop();
      isQueued_[item.second] = false;
      if (!isOpen(item.second)) continue;
      if (isNear_[item.second]) {
        left.push_back(item);
        continue;
      }
      taken.push_back(item.second);
      addAround(item.second, graph, near);
    }
    for (const Index base : near) isNear_[base] = false;
    for (const auto& [length, base] : left) add(base, length);
    return taken;
  }

 private:
  using Item = std::pair<double, Index>;

  void addAround(Index base, const BaseGraph& graph, std::vector<Index>& near) {
    std::vector<Index> around{base};
    std::size_t next = 0;
    for (int edges = 0; edges < 2; ++edges) {
      for (const std::size_t end = around.size(); next < end; ++next) {
        for (const Neighbour& other : graph.neighbours(around[next])) {
          if (std::find(around.begin(), around.end(), other.base) == around.end()) {
            around.push_back(other.base);
          }
        }
      }
    }
    for (const Index other : around) isNear_[other] = true;
    near.insert(near.end(), around.begin(), around.end());
  }

  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue_;
  std::vector<bool> isQueued_, isNear_;
};

}  // namespace girth
