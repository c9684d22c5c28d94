// A priority queue for a front that moves outward: items by distance, in buckets of equal width.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::geodesic {

/// Items come out bucket by bucket, in the order of their keys up to the width of a bucket, and in
/// the order they were pushed within one. Pushing below the current bucket counts as the current
/// one. O(1) each.
class BucketQueue {
 public:
  explicit BucketQueue(double width) : inverseWidth_(1 / width), width_(width), ring_(kRing) {}

  void clear() {
    if (size_ > 0) {
      for (auto& bucket : ring_) bucket.clear();
      far_.clear();
    }
    ring_[current_ % kRing].clear();
    size_ = current_ = position_ = 0;
  }

  bool empty() const { return size_ == 0; }

  void push(double key, Index item) {
    const std::size_t number = std::max(current_, bucketOf(key));
    if (number - current_ < kRing) {
      ring_[number % kRing].push_back(item);
    } else {
      far_.push_back({number, item});
    }
    ++size_;
  }

  /// Everything below this distance has come out.
  double frontier() const { return static_cast<double>(current_) * width_; }

  /// Whether the current bucket still holds items; if not, `advance` before `pop`.
  bool bucketDone() const { return position_ == ring_[current_ % kRing].size(); }

  /// Moves to the next bucket that holds anything. Only where not empty.
  void advance() {
    do {
      ring_[current_ % kRing].clear();
      position_ = 0;
      ++current_;
      if (far_.size() == size_) current_ = nearestFar();  // nothing in the ring: skip the void
      if (!far_.empty()) bringNear();
    } while (bucketDone());
  }

  Index pop() {
    --size_;
    return ring_[current_ % kRing][position_++];
  }

  std::size_t memoryBytes() const {
    std::size_t bytes = far_.capacity() * sizeof(Far);
    for (const auto& bucket : ring_) bytes += bucket.capacity() * sizeof(Index);
    return bytes;
  }

 private:
  static constexpr std::size_t kRing = 256;
  struct Far {
    std::size_t number;
    Index item;
  };

  std::size_t bucketOf(double key) const { return static_cast<std::size_t>(key * inverseWidth_); }

  std::size_t nearestFar() const {
    return std::min_element(far_.begin(), far_.end(),
                            [](const Far& a, const Far& b) { return a.number < b.number; })
        ->number;
  }

  void bringNear() {
    const auto isFar = [&](const Far& far) { return far.number - current_ >= kRing; };
    const auto middle = std::stable_partition(far_.begin(), far_.end(), isFar);
    for (auto it = middle; it != far_.end(); ++it) ring_[it->number % kRing].push_back(it->item);
    far_.erase(middle, far_.end());
  }

  double inverseWidth_, width_;
  std::size_t size_{0}, current_{0}, position_{0};
  std::vector<std::vector<Index>> ring_;
  std::vector<Far> far_;
};

}  // namespace girth::geodesic
