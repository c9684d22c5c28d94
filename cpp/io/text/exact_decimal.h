// Decimal numbers of any length as doubles.
#pragma once

#include <string_view>

namespace girth::io {

/// `digits` · 10^`exponent`, rounded correctly (to even where it lies halfway); infinite where it
/// is too large. By whole numbers, since C libraries heed the locale, and not all of them round
/// correctly. `digits`: 0 to 9 alone.
double exactDecimal(std::string_view digits, int exponent);

}  // namespace girth::io
