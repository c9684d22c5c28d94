// An hourglass of known girth.
#pragma once

#include <string>

namespace girth::test {

inline constexpr int kHourglassVertices = 18;

/// Two open funnels joined at their narrow rims, as OBJ: hexagons with corners 2, 1 and 2 from
/// their centres at z = 0, 3 and 6. Vertices are numbered from the lowest hexagon up. `shift`:
/// along x; `before`: vertices that stand before it in the file.
std::string hourglass(double shift = 0, int before = 0);

}  // namespace girth::test
