// Regular shapes with rounded coordinates, as CAD programs export them, each known by its seed.
//
// On such shapes many loops of nearly equal length lie side by side, and run along edges whose
// vertices are flat but for rounding.
#pragma once

#include <cstdint>
#include <string>

#include "shapes.h"

namespace girth::test {

struct RegularShape {
  Shape shape;
  /// How it was made, for messages.
  std::string history;
};

/// The surface of this seed, of some 10 to 250 vertices: a prism, tube, torus, cone, box, flat
/// sheet, sphere, surface of revolution, extruded profile or a union of two of them, in one of
/// three triangulations; turned, scaled, moved and rounded at random. Connected, without corners
/// narrower than 1e-3; open ones have boundaries.
RegularShape regularShape(std::uint64_t seed);

}  // namespace girth::test
