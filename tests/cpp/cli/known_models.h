// Models whose loops are known, as OBJ.
#pragma once

#include <string>

namespace girth::test {

inline constexpr int kHourglassVertices = 18;

/// Two open funnels joined at their narrow rims, hexagons with corners 2, 1 and 2 from
/// their centres at z = 0, 3 and 6. Vertices are numbered from the lowest hexagon up. `shift`:
/// along x; `before`: vertices that stand before it in the file.
std::string hourglass(double shift = 0, int before = 0);

/// A square of 3 × 3, 1/2 thick, with a hole of 1 × 1 in its middle: a handle loop of 3 and a
/// tunnel loop of 4.
std::string frame();

}  // namespace girth::test
