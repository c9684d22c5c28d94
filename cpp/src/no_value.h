// The number that stands where a field or a summary has no value.
#pragma once

#include <limits>

namespace girth {

inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

}  // namespace girth
