// Shares of a study, computed by several machines at once.
#pragma once

#include <cstddef>
#include <string>

#include "girth/error.h"

namespace girth::cli {

/// "2/8": the third of eight shares, counted from 0.
struct Shard {
  std::size_t number{0}, count{1};

  bool has(std::size_t work) const { return work % count == number; }
};

/// Error: USAGE.
Result<Shard> parseShard(const std::string& text);

}  // namespace girth::cli
