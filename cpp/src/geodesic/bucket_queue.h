// A priority queue for a front that moves outward: items by distance, in buckets of equal width.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::geodesic {

/// Items come out bucket by bucket, and in the order they were pushed within one. Nothing is pushed
/// below the current bucket: such keys count as the current one. O(1) each.
class BucketQueue {
 public:
  explicit BucketQueue(double width) : inverseWidth_(1 / width), width_(width), ring_(kRing) {}

  void clear() {
    if (size_ > 0) {
      for (auto& bucket : ring_) bucket.clear();
      far_.clear();
    }
    ring_[current_ % kRing].clear();
    size_ = position_ = 0;
    current_ = 0;
  }

  bool empty() const { return size_ == 0; }

  /// The bucket for a key: no earlier than the current one.
  std::uint32_t bucketOf(double key) const {
    const double number = key * inverseWidth_;
    return number < kLast ? std::max(current_, static_cast<std::uint32_t>(number)) : kLast;
  }
  void push(std::uint32_t bucket, Index item) {
    if (bucket - current_ < kRing) {
      ring_[bucket % kRing].push_back(item);
    } else {
      far_.push_back({bucket, item});
    }
    ++size_;
  }

  std::uint32_t current() const { return current_; }
  /// Everything below this distance has come out.
  double frontier() const { return current_ * width_; }

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

  /// What comes out after so many others, within the current bucket; `none` beyond it.
  Index ahead(std::size_t others, Index none) const {
    const auto& bucket = ring_[current_ % kRing];
    const std::size_t position = position_ + others;
    return position < bucket.size() ? bucket[position] : none;
  }

  std::size_t memoryBytes() const {
    std::size_t bytes = far_.capacity() * sizeof(Far);
    for (const auto& bucket : ring_) bytes += bucket.capacity() * sizeof(Index);
    return bytes;
  }

 private:
  static constexpr std::uint32_t kRing = 256;
  static constexpr std::uint32_t kLast = 0xFFFFFFF0u;
  struct Far {
    std::uint32_t bucket;
    Index item;
  };

  std::uint32_t nearestFar() const {
    return std::min_element(far_.begin(), far_.end(),
                            [](const Far& a, const Far& b) { return a.bucket < b.bucket; })
        ->bucket;
  }

  void bringNear() {
    const auto isFar = [&](const Far& far) { return far.bucket - current_ >= kRing; };
    const auto middle = std::stable_partition(far_.begin(), far_.end(), isFar);
    for (auto it = middle; it != far_.end(); ++it) ring_[it->bucket % kRing].push_back(it->item);
    far_.erase(middle, far_.end());
  }

  double inverseWidth_, width_;
  std::uint32_t current_{0};
  std::size_t size_{0}, position_{0};
  std::vector<std::vector<Index>> ring_;
  std::vector<Far> far_;
};

}  // namespace girth::geodesic
