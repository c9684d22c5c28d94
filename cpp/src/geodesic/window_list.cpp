#include "geodesic/window_list.h"

#include <algorithm>
#include <cstring>

namespace girth::geodesic {

void WindowPool::grow(WindowList& list, std::uint32_t count) {
  std::uint8_t sizeClass = 0;
  while ((std::size_t{WindowList::kSmallest} << sizeClass) < count) ++sizeClass;
  double* block = take(sizeClass);
  if (list.data != nullptr) {
    const std::size_t capacity = std::size_t{WindowList::kSmallest} << sizeClass;
    for (std::size_t field = 0; field < 5; ++field) {
      const double* from = list.data + field * list.capacity();
      std::copy(from, from + list.count, block + field * capacity);
    }
    giveBack(list.data, list.sizeClass);
  }
  list.data = block;
  list.sizeClass = sizeClass;
}

double* WindowPool::take(unsigned sizeClass) {
  const std::size_t size = doublesOf(sizeClass);
  used_ += size * sizeof(double);
  if (double* block = free_[sizeClass]) {
    std::memcpy(&free_[sizeClass], static_cast<void*>(block), sizeof(double*));
    return block;
  }
  if (size > kSlab) {
    large_.push_back(std::unique_ptr<double[]>(new double[size]));
    largeBytes_ += size * sizeof(double);
    return large_.back().get();
  }
  if (slab_ < slabs_.size() && offset_ + size > kSlab) {
    ++slab_;
    offset_ = 0;
  }
  if (slab_ == slabs_.size()) slabs_.push_back(std::unique_ptr<double[]>(new double[kSlab]));
  double* block = slabs_[slab_].get() + offset_;
  offset_ += size;
  return block;
}

void WindowPool::giveBack(double* block, unsigned sizeClass) {
  used_ -= doublesOf(sizeClass) * sizeof(double);
  std::memcpy(static_cast<void*>(block), &free_[sizeClass], sizeof(double*));
  free_[sizeClass] = block;
}

void WindowPool::reset() {
  free_.fill(nullptr);
  large_.clear();
  largeBytes_ = 0;
  slab_ = offset_ = used_ = 0;
}

}  // namespace girth::geodesic
