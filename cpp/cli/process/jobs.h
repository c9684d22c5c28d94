// Many models, several at a time, each in a process of its own: what goes wrong with one cannot
// harm another, and each has its own memory.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace girth::cli {

/// Works on every item, by its number, and returns the greatest exit code. `work` prints and
/// returns an exit code; `items`: what messages call them. With `jobs` above 1 so many processes
/// work at a time; what they print comes out whole, in the order of the items. After an
/// interruption no further item is begun, and those at work are stopped.
int forEachJob(std::span<const std::string> items, unsigned jobs,
               const std::function<int(std::size_t item)>& work);

}  // namespace girth::cli
