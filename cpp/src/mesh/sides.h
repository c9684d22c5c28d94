// Halfedges as plain numbers: side k of face f is 3 f + k.
#pragma once

#include "girth/elements.h"

namespace girth {

/// The next side of the same face. (Whether 3 divides a number is found without a division.)
constexpr Index nextSide(Index side) { return (side + 1) % 3 == 0 ? side - 2 : side + 1; }
/// The side before, of the same face.
constexpr Index previousSide(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }
/// The face that a side belongs to.
constexpr Index faceOfSide(Index side) { return side / 3; }

}  // namespace girth
