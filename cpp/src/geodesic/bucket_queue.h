// A priority queue for a front that moves outward: items by distance, in buckets of equal width.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::geodesic {

/// Items come out bucket by bucket, and in the order they were pushed within one. Nothing is pushed
/// below the current bucket: such keys count as the current one. O(1) each, and O(log n) where the
/// bucket is far ahead, as across edges far longer than most.
class BucketQueue {
 public:
  explicit BucketQueue(double width) : inverseWidth_(1 / width), width_(width), ring_(kRing) {}

  /// From now on buckets are so wide. Only where empty and at the beginning.
  void setWidth(double width) {
    inverseWidth_ = 1 / width;
    width_ = width;
  }

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
      far_.push_back({bucket, item, pushedFar_++});
      std::push_heap(far_.begin(), far_.end(), later);
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
      // Nothing in the ring: skip the void.
      if (far_.size() == size_) current_ = far_.front().bucket;
      while (!far_.empty() && far_.front().bucket - current_ < kRing) bringNear();
    } while (bucketDone());
  }

  Index pop() {
    --size_;
    return ring_[current_ % kRing][position_++];
  }

  /// The element that comes out after so many others, within the current bucket; `none` beyond it.
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
    std::uint64_t number;  ///< in the order in which they were pushed
  };
  static bool later(const Far& a, const Far& b) {
    return a.bucket != b.bucket ? a.bucket > b.bucket : a.number > b.number;
  }

  /// The nearest of those far ahead enters the ring.
  void bringNear() {
    std::pop_heap(far_.begin(), far_.end(), later);
    ring_[far_.back().bucket % kRing].push_back(far_.back().item);
    far_.pop_back();
  }

  double inverseWidth_, width_;
  std::uint32_t current_{0};
  std::size_t size_{0}, position_{0};
  std::vector<std::vector<Index>> ring_;
  std::vector<Far> far_;  ///< a heap, the nearest on top
  std::uint64_t pushedFar_{0};
};

}  // namespace girth::geodesic
