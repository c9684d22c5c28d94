// The colour map of exported models.
#pragma once

#include <array>
#include <cstdint>

namespace girth::io {

/// Red, green and blue in linear light, 65535 at full.
using LinearColour = std::array<std::uint16_t, 3>;

/// Viridis, by S. van der Walt and N. Smith (in the public domain by CC0), at a fraction of the way
/// from dark to light; fractions beyond the ends take the end.
LinearColour viridis(double fraction);

}  // namespace girth::io
