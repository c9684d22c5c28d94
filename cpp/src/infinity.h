// Infinity: of distances not reached, of what never ends.
#pragma once

#include <limits>

namespace girth {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace girth
