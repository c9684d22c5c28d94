// Surfaces of revolution for tests.
#pragma once

#include <vector>

#include "shapes.h"

namespace girth::test {

/// A ring of a surface of revolution: a regular polygon round the z axis.
struct Ring {
  double z, radius;  ///< radius of its circumscribed circle
};

/// A surface of revolution with regular polygons of `sides` corners for rings, one corner at y = 0,
/// x > 0 in each; z rises from ring to ring. `capped`: closed at both ends round their centres,
/// which come last. Vertex (ring, corner) has the number ring × sides + corner.
Shape lathe(const std::vector<Ring>& rings, Index sides, bool capped = true);

/// The perimeter of a regular polygon.
double polygonLength(double radius, Index sides);

}  // namespace girth::test
