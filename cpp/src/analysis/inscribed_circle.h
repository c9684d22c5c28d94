// The largest circle inside a polygon with holes.
#pragma once

#include <vector>

#include "analysis/convex_hull.h"

namespace girth {

struct InscribedCircle {
  Point2 centre;
  double radius{0};
};

/// The largest circle that no side of any ring meets and whose centre lies inside: where a ray
/// crosses the sides of all rings an odd number of times. Radius 0 where there is none.
///
/// Branch and bound over squares. Within a square, how far each side lies away is at most linear,
/// up to half the squared radius of the square by that distance; the least of these has its
/// greatest value at a corner of a linear program in two unknowns, which bounds the square and
/// proposes a centre. It ends where no square can exceed the best circle by 1e-12 of its radius, or
/// after 100,000 squares.
InscribedCircle inscribedCircle(const std::vector<std::vector<Point2>>& rings);

}  // namespace girth
