#include "geodesic/window_list.h"

#include <algorithm>
#include <new>

namespace girth::geodesic {

namespace {

std::size_t bytesOf(std::uint32_t windows) {
  return sizeof(WindowRun) + WindowRun::kFields * sizeof(double) * WindowRun::strideOf(windows);
}

}  // namespace

void WindowPool::Delete::operator()(Block* block) const {
  ::operator delete (block, std::align_val_t{kBlockBytes});
}

WindowPool::Block* WindowPool::blockOf(const WindowRun* run) {
  const auto address = reinterpret_cast<std::uintptr_t>(run);
  return reinterpret_cast<Block*>(address & ~(std::uintptr_t{kBlockBytes} - 1));
}

WindowRun* WindowPool::take(std::uint32_t count) {
  const std::size_t bytes = bytesOf(count);
  if (current_ == nullptr || current_->used + bytes + kSpare * sizeof(double) > current_->bytes) {
    open(bytes);
  }
  auto* memory = reinterpret_cast<std::byte*>(current_) + current_->used;
  current_->used += bytes;
  ++current_->waiting;
  return new (memory) WindowRun{nullptr, 0, count};
}

/// Makes a free block with room for a run the current one.
void WindowPool::open(std::size_t bytes) {
  const std::size_t wanted = std::max(kBlockBytes, sizeof(Block) + bytes + kSpare * sizeof(double));
  // The block that was used last, and is still in the cache, comes first.
  std::size_t free = used_;
  while (free < blocks_.size() && blocks_[free]->bytes < wanted) ++free;
  if (free == blocks_.size()) {
    void* memory = ::operator new (wanted, std::align_val_t{kBlockBytes});
    blocks_.emplace_back(new (memory) Block{wanted, 0, 0, 0});
  }
  std::swap(blocks_[used_], blocks_[free]);
  current_ = blocks_[used_++].get();
  current_->used = sizeof(Block);
  current_->waiting = 0;
  current_->farthest = 0;
  grown_ = true;
}

void WindowPool::forget(float passed) {
  for (std::size_t i = used_; i-- > 0;) {
    const Block* block = blocks_[i].get();
    if (block == current_ || block->waiting > 0 || !(block->farthest < passed)) continue;
    std::swap(blocks_[i], blocks_[--used_]);
  }
  grown_ = false;
}

void WindowPool::reset() {
  used_ = 0;
  current_ = nullptr;
  grown_ = false;
}

std::size_t WindowPool::memoryBytes() const {
  std::size_t bytes = 0;
  for (const auto& block : blocks_) bytes += block->bytes;
  return bytes;
}

}  // namespace girth::geodesic
