// Work on several models at a time, each in a process of its own, where programs can fork (POSIX).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace girth::cli {

/// As `forEachJob`, with more than one at a time.
int forkedJobs(std::span<const std::string> items, unsigned jobs,
               const std::function<int(std::size_t item)>& work);

}  // namespace girth::cli
