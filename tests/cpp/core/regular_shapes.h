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

/// From this seed on shapes are unions of bodies: of boxes, or of prisms with one axis.
inline constexpr std::uint64_t kFirstUnion = 20'000;

/// The surface of this seed, of some 10 to 250 vertices: a prism, tube, torus, cone, box, flat
/// sheet, sphere, surface of revolution or extruded profile, in one of three triangulations, or a
/// union; turned, scaled, moved and rounded at random. Connected, without corners narrower than
/// 1e-3; open ones have boundaries.
RegularShape regularShape(std::uint64_t seed);

}  // namespace girth::test
