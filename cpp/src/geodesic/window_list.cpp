#include "geodesic/window_list.h"

#include <algorithm>
#include <new>

namespace girth::geodesic {

void WindowPool::Delete::operator()(Block* block) const {
  ::operator delete (block, std::align_val_t{kBlockBytes});
}

/// A free block with room for a run.
WindowPool::Block* WindowPool::open(std::size_t bytes) {
  const std::size_t wanted = std::max(kBlockBytes, sizeof(Block) + bytes);
  // The block that was used last, and is still in the cache, comes first.
  std::size_t free = used_;
  while (free < blocks_.size() && blocks_[free]->bytes < wanted) ++free;
  if (free == blocks_.size()) {
    void* memory = ::operator new (wanted, std::align_val_t{kBlockBytes});
    blocks_.emplace_back(new (memory) Block{wanted, 0, 0, 0});
  }
  std::swap(blocks_[used_], blocks_[free]);
  Block* block = blocks_[used_++].get();
  block->used = sizeof(Block);
  block->pending = 0;
  block->farthest = 0;
  grown_ = true;
  return block;
}

void WindowPool::forget(float passed) {
  for (std::size_t i = used_; i-- > 0;) {
    const Block* block = blocks_[i].get();
    const bool current = block == current_[0] || block == current_[1];
    if (!current && block->pending == 0 && block->farthest < passed) {
      std::swap(blocks_[i], blocks_[--used_]);
    }
  }
  grown_ = false;
}

void WindowPool::reset() {
  used_ = 0;
  current_ = {};
  grown_ = false;
}

std::size_t WindowPool::memoryBytes() const {
  std::size_t bytes = 0;
  for (const auto& block : blocks_) bytes += block->bytes;
  return bytes;
}

}  // namespace girth::geodesic
