#include "loops/necks/minimax_paths.h"

#include <algorithm>
#include <functional>

#include "infinity.h"

namespace girth::loops {

void MinimaxPaths::fit() {
  reached_.resize(values_.size(), kInfinity);
  before_.resize(values_.size(), kNoIndex);
  settledAt_.resize(values_.size(), kNoIndex);
  atLevel_.fit(values_.size());
}

void MinimaxPaths::start(std::span<const Index> starts, double level) {
  reached_.clear();
  before_.clear();
  settledAt_.clear();
  settled_.clear();
  others_.clear();
  atLevel_ = {};
  level_ = level;
  fit();
  for (const Index node : starts) {
    reached_[node] = level;
    enqueue(node);
  }
}

void MinimaxPaths::enqueue(Index node) {
  if (reached_[node] == level_) {
    atLevel_.insert(node);
  } else {
    others_.emplace_back(reached_[node], node);
    std::push_heap(others_.begin(), others_.end(), std::greater<>());
  }
}

Index MinimaxPaths::first() {
  const auto pop = [&] {
    std::pop_heap(others_.begin(), others_.end(), std::greater<>());
    others_.pop_back();
  };
  while (!others_.empty() && (atLevel_.empty() || others_.front().first < level_)) {
    const auto [height, node] = others_.front();
    if (reached_[node] != height || isSettled(node)) {
      pop();
      continue;
    }
    // The level changes.
    while (!atLevel_.empty()) {
      const Index other = atLevel_.least();
      atLevel_.erase(other);
      others_.emplace_back(level_, other);
      std::push_heap(others_.begin(), others_.end(), std::greater<>());
    }
    level_ = height;
    while (!others_.empty() && others_.front().first == level_) {
      const Index next = others_.front().second;
      if (reached_[next] == level_ && !isSettled(next)) atLevel_.insert(next);
      pop();
    }
  }
  return atLevel_.empty() ? kNoIndex : atLevel_.least();
}

void MinimaxPaths::takeOut(Index node) {
  if (reached_[node] == level_ && !isSettled(node)) atLevel_.erase(node);
  reached_[node] = kInfinity;
  before_[node] = kNoIndex;
}

void MinimaxPaths::reach(Index node, Index from) {
  // NaN is no way.
  if (!(values_[node] < kInfinity)) return;
  reached_[node] = std::max(reached_[from], values_[node]);
  before_[node] = from;
  enqueue(node);
}

MinimaxPaths::Path MinimaxPaths::to(const std::vector<bool>& isEnd) {
  for (Index node = first(); node != kNoIndex; node = first()) {
    // An end stays in the queue: the way to it may change.
    if (node < isEnd.size() && isEnd[node]) {
      Path way{level_, {}};
      for (Index at = node; at != kNoIndex; at = before_[at]) way.nodes.push_back(at);
      return way;
    }
    atLevel_.erase(node);
    settledAt_[node] = static_cast<Index>(settled_.size());
    settled_.push_back(node);
    for (const Index next : neighbours_[node]) {
      if (reached_[next] == kInfinity) reach(next, node);
    }
  }
  return {kInfinity, {}};
}

void MinimaxPaths::reachFromFirst(Index node) {
  Index first = kNoIndex;
  for (const Index next : neighbours_[node]) {
    if (isSettled(next) && (first == kNoIndex || settledAt_[next] < settledAt_[first])) {
      first = next;
    }
  }
  if (first != kNoIndex) reach(node, first);
}

void MinimaxPaths::undo(std::size_t place) {
  for (std::size_t i = place; i < settled_.size(); ++i) {
    for (const Index next : neighbours_[settled_[i]]) {
      if (before_[next] == settled_[i]) takeOut(next);
    }
  }
  for (std::size_t i = place; i < settled_.size(); ++i) {
    settledAt_[settled_[i]] = kNoIndex;
    if (reached_[settled_[i]] < kInfinity) enqueue(settled_[i]);
  }
  settled_.resize(place);
  if (others_.size() > 2 * values_.size()) dropOutdated();
}

void MinimaxPaths::dropOutdated() {
  std::erase_if(others_, [&](const Entry& entry) {
    return reached_[entry.second] != entry.first || isSettled(entry.second);
  });
  // In rising order it is a heap.
  std::sort(others_.begin(), others_.end());
  others_.erase(std::unique(others_.begin(), others_.end()), others_.end());
}

void MinimaxPaths::leave(Index node, Index from) {
  if (before_[node] != from) return;
  if (isSettled(node)) undo(settledAt_[node]);
  takeOut(node);
  reachFromFirst(node);
}

void MinimaxPaths::onDivision(Index a, Index b, Index node) {
  fit();
  leave(a, b);
  leave(b, a);
  reachFromFirst(node);
  if (reached_[node] == kInfinity) return;
  // It has the greatest number, and so comes last among those of its height.
  const auto behind =
      std::upper_bound(settled_.begin(), settled_.end(), reached_[node],
                       [&](double height, Index settled) { return height < reached_[settled]; });
  undo(static_cast<std::size_t>(behind - settled_.begin()));
}

}  // namespace girth::loops
