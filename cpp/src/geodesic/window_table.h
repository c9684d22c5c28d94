// Which windows each halfedge has, without keeping a list for each: lists are there for the
// halfedges that windows have come to and the front has not passed. Other halfedges have one word
// each. Data that is looked at again and again lies close together, and memory grows with the
// front.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "geodesic/prefetch.h"
#include "geodesic/window_list.h"

namespace girth::geodesic {

/// A list for every halfedge, most of which share one.
class WindowTable {
 public:
  explicit WindowTable(std::size_t halfedgeCount)
      : slot_(halfedgeCount, kEmpty), lists_(kShared), halfedge_(kShared, kNoIndex) {
    lists_[kPassed].farthest = -1;
  }

  /// The list of a halfedge: an empty one where no window has come; where the front has passed, one
  /// that is nearer than everything. Valid until the next call of `open`.
  const WindowList& operator[](Index halfedge) const { return lists_[slot_[halfedge]]; }
  /// The list of a halfedge that has been opened.
  WindowList& opened(Index halfedge) { return lists_[slot_[halfedge]]; }
  /// The list of a halfedge to which windows come; not of one that the front has passed.
  WindowList& open(Index halfedge) {
    Index& slot = slot_[halfedge];
    if (slot == kEmpty) {
      slot = unused();
      halfedge_[slot] = halfedge;
      touched_.push_back(halfedge);
    }
    return lists_[slot];
  }
  /// The halfedges to which windows have come.
  const std::vector<Index>& touched() const { return touched_; }
  /// The halfedge has no windows any more.
  void close(Index halfedge) { release(slot_[halfedge], kEmpty); }

  /// The front has passed all lists that are nearer than `passed` and whose windows have all
  /// crossed. Looks for them only when there are twice as many as last time: O(1) for each that was
  /// opened.
  void forget(float passed) {
    if (lists_.size() - unused_.size() < worthwhile_) return;
    for (Index slot = kShared; slot < lists_.size(); ++slot) {
      const WindowList& list = lists_[slot];
      const bool isDone = list.count > 0 && list.entered == list.count;
      if (isDone && list.farthest < passed) release(slot, kPassed);
    }
    worthwhile_ = std::max(kFew, 2 * (lists_.size() - unused_.size()));
  }

  /// Closes all halfedges, in proportion to how many have been opened.
  void clear() {
    constexpr std::size_t kAhead = 12;
    for (std::size_t i = 0; i < touched_.size(); ++i) {
      if (i + kAhead < touched_.size()) prefetchWord(touched_[i + kAhead]);
      slot_[touched_[i]] = kEmpty;
    }
    touched_.clear();
    unused_.clear();
    lists_.resize(kShared);
    halfedge_.resize(kShared);
    worthwhile_ = kFew;
  }

  /// Fetches the word that locates a list into the cache, before it is needed.
  void prefetchWord(Index halfedge) const { prefetch(&slot_[halfedge]); }

  std::size_t memoryBytes() const {
    return lists_.capacity() * sizeof(WindowList) +
           (slot_.capacity() + halfedge_.capacity() + touched_.capacity() + unused_.capacity()) *
               sizeof(Index);
  }

 private:
  /// The shared lists: of halfedges without windows, and of those that the front has passed.
  static constexpr Index kEmpty = 0, kPassed = 1, kShared = 2;
  static constexpr std::size_t kFew = 1024;

  Index unused() {
    if (unused_.empty()) {
      lists_.emplace_back();
      halfedge_.push_back(kNoIndex);
      return static_cast<Index>(lists_.size() - 1);
    }
    const Index slot = unused_.back();
    unused_.pop_back();
    return slot;
  }
  void release(Index slot, Index instead) {
    slot_[halfedge_[slot]] = instead;
    lists_[slot] = WindowList{};
    unused_.push_back(slot);
  }

  std::vector<Index> slot_;        // lists by halfedge
  std::vector<WindowList> lists_;  // first the shared ones
  std::vector<Index> halfedge_;    // halfedges by list
  std::vector<Index> touched_;     // halfedges that have been opened
  std::vector<Index> unused_;      // lists
  std::size_t worthwhile_{kFew};   // so many lists make it worth looking for those that are passed
};

}  // namespace girth::geodesic
