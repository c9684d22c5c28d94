#include "lathe.h"

#include <cmath>

namespace girth::test {

Shape lathe(const std::vector<Ring>& rings, Index sides, bool capped) {
  Shape shape;
  for (const Ring& ring : rings) {
    for (Index i = 0; i < sides; ++i) {
      const double angle = 2 * M_PI * i / sides;
      shape.add(ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.z);
    }
  }
  const auto count = static_cast<Index>(rings.size());
  for (Index k = 0; k + 1 < count; ++k) {
    for (Index i = 0; i < sides; ++i) {
      const Index a = k * sides + i, b = k * sides + (i + 1) % sides;
      shape.face(a, b, b + sides);
      shape.face(a, b + sides, a + sides);
    }
  }
  if (!capped) return shape;
  const Index bottom = shape.add(0, 0, rings.front().z), top = shape.add(0, 0, rings.back().z);
  for (Index i = 0; i < sides; ++i) {
    const Index j = (i + 1) % sides, last = (count - 1) * sides;
    shape.face(bottom, j, i);
    shape.face(top, last + i, last + j);
  }
  return shape;
}

double polygonLength(double radius, Index sides) {
  return 2 * sides * radius * std::sin(M_PI / sides);
}

}  // namespace girth::test
