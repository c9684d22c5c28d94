// Objects that threads work with, kept from one piece of work to the next.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace girth {

/// Things of which each thread needs one for itself; as many are made as are in use at once.
template <class Thing>
class IdlePool {
 public:
  /// Calls `work(Thing&)` with one that nobody else uses meanwhile; `make()`, where there is none,
  /// gives a new one as a unique_ptr.
  template <class Make, class Work>
  void use(Make&& make, Work&& work) {
    std::unique_ptr<Thing> thing = taken();
    if (!thing) thing = make();
    work(*thing);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(thing));
  }

 private:
  std::unique_ptr<Thing> taken() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return nullptr;
    std::unique_ptr<Thing> thing = std::move(idle_.back());
    idle_.pop_back();
    return thing;
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<Thing>> idle_;
};

}  // namespace girth
