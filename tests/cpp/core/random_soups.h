// Random triangles that are no surface yet, each known by its seed.
#pragma once

#include <cstdint>

#include "shapes.h"

namespace girth::test {

/// Triangles at random over a few places of a small grid: much coincides, lines up and crosses.
Shape randomSoup(std::uint64_t seed);

/// Leftovers of models besides a surface: several of a random soup, doubled faces, doubled
/// needles, sheets that touch along edges, fans round a vertex and round an edge, strips of
/// slivers, cubes side by side, and now and then a whole surface. 2 to some `most` faces.
Shape randomLeftovers(std::uint64_t seed, Index most = 600);

}  // namespace girth::test
