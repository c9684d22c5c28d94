#include "random_soups.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace girth::test {

Shape randomSoup(std::uint64_t seed) {
  Random random(seed);
  Shape shape;
  const Index grid = 2 + random.below(4), vertices = 4 + random.below(20);
  const double jitter = random() < 0.3 ? 0.5 : 0;
  for (Index i = 0; i < vertices; ++i) {
    const auto coordinate = [&] { return random.below(grid) + jitter * random(); };
    const double x = coordinate(), y = coordinate(), z = random() < 0.3 ? 0 : coordinate();
    shape.add(x, y, z);
  }
  const Index faces = 1 + random.below(60);
  for (Index i = 0; i < faces; ++i) {
    if (i > 0 && random() < 0.1) {  // a copy, turned somehow
      const Index f = random.below(i);
      const Index* v = &shape.triangles[3 * std::size_t{f}];
      const Index k = random.below(3), a = v[k], b = v[(k + 1) % 3], c = v[(k + 2) % 3];
      random() < 0.5 ? shape.face(a, b, c) : shape.face(a, c, b);
    } else {
      const Index a = random.below(vertices), b = random.below(vertices),
                  c = random.below(vertices);
      shape.face(a, b, c);
    }
  }
  return shape;
}

namespace {

/// Adds what is drawn elsewhere, somewhere near.
void append(Shape& shape, const Shape& other, Random& random) {
  const Index first = shape.vertexCount();
  const double x = random.below(3), y = random.below(3), z = random.below(2);
  for (std::size_t i = 0; i < other.positions.size(); i += 3) {
    shape.add(other.positions[i] + x, other.positions[i + 1] + y, other.positions[i + 2] + z);
  }
  for (std::size_t i = 0; i < other.triangles.size(); i += 3) {
    shape.face(first + other.triangles[i], first + other.triangles[i + 1],
               first + other.triangles[i + 2]);
  }
}

/// Two faces on each other; or four, the fourth vertex of which lies on the triangle of the others.
Shape doubledNeedle(Random& random) {
  Shape shape;
  const double width = std::pow(10.0, -9 * random());
  shape.add(0, 0, 0);
  shape.add(1, 0, 0);
  shape.add(0.3, width, 0);
  if (random() < 0.4) {
    shape.face(0, 1, 2);
    shape.face(0, 2, 1);
    return shape;
  }
  shape.add(0.5, width / 3, 0);
  shape.face(0, 1, 2);
  shape.face(0, 3, 1);
  shape.face(0, 2, 3);
  shape.face(1, 3, 2);
  return shape;
}

/// Faces round a vertex, flat or not, closed or open.
Shape fanRoundVertex(Random& random) {
  Shape shape;
  const Index faces = 3 + random.below(40);
  const double height = random() < 0.3 ? 0 : 2 * random() - 1;
  const bool closed = random() < 0.5;
  shape.add(0, 0, height);
  for (Index i = 0; i <= faces; ++i) {
    const double angle = 2 * M_PI * i / (closed ? faces : faces + 1);
    if (i < faces || !closed) shape.add(std::cos(angle), std::sin(angle), 0);
  }
  for (Index i = 0; i < faces; ++i) {
    shape.face(0, 1 + i, closed ? 1 + (i + 1) % faces : 2 + i);
  }
  return shape;
}

/// The pages of a book, some of them doubled.
Shape fanRoundEdge(Random& random) {
  Shape shape;
  const Index pages = 2 + random.below(12);
  shape.add(0, 0, 0);
  shape.add(0, 0, 1);
  for (Index i = 0; i < pages; ++i) {
    const double angle = 2 * M_PI * i / pages;
    const Index v = shape.add(std::cos(angle), std::sin(angle), random());
    shape.face(0, 1, v);
    if (random() < 0.5) shape.face(1, 0, v);
  }
  return shape;
}

/// A strip far longer than it is wide.
Shape strip(Random& random) {
  Shape shape;
  const Index pieces = 1 + random.below(30);
  const double width = std::pow(10.0, -7 * random());
  for (Index i = 0; i <= pieces; ++i) {
    shape.add(i, 0, 0.1 * random());
    shape.add(i, width, 0.1 * random());
  }
  for (Index i = 0; i < pieces; ++i) {
    shape.face(2 * i, 2 * i + 2, 2 * i + 1);
    shape.face(2 * i + 2, 2 * i + 3, 2 * i + 1);
  }
  return shape;
}

/// Faces of another shape once more, turned over: sheets on each other.
void doubleSome(Shape& shape, Random& random) {
  const std::size_t faces = shape.triangles.size() / 3;
  const double share = random();
  for (std::size_t f = 0; f < faces; ++f) {
    if (random() > share) continue;
    shape.face(shape.triangles[3 * f], shape.triangles[3 * f + 2], shape.triangles[3 * f + 1]);
  }
}

Shape whole(Random& random, Index most) {
  switch (random.below(4)) {
    case 0:
      return most > 2000 && random() < 0.5 ? icosphere(4) : icosphere(random.below(3));
    case 1:
      return torus(3, 1, 3 + random.below(30), 3 + random.below(20));
    case 2:
      return plate(1 + random.below(3));
    default:
      return box(1, 1 + random(), 1e-3, 1 + random.below(6), 1 + random.below(6), 1);
  }
}

}  // namespace

Shape randomLeftovers(std::uint64_t seed, Index most) {
  Random random(seed);
  Shape shape;
  const Index pieces = 1 + random.below(6);
  for (Index i = 0; i < pieces && shape.triangles.size() / 3 < most; ++i) {
    Shape piece;
    switch (random.below(7)) {
      case 0:
        piece = randomSoup(seed * 7 + i);
        break;
      case 1:
        piece = doubledNeedle(random);
        break;
      case 2:
        piece = fanRoundVertex(random);
        break;
      case 3:
        piece = fanRoundEdge(random);
        break;
      case 4:
        piece = strip(random);
        break;
      case 5:
        piece = box(1, 1, 1, 1 + random.below(3), 1 + random.below(3), 1);
        break;
      default:
        piece = whole(random, most);
    }
    if (random() < 0.3) doubleSome(piece, random);
    append(shape, piece, random);
  }
  return shape;
}

}  // namespace girth::test
