#include "regular_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <vector>

#include "mesh/vector.h"
#include "print_shapes.h"
#include "random_meshes.h"

namespace girth::test {

namespace {

constexpr Index kMostVertices = 250;
/// Needles narrower than this are left to other tests.
constexpr double kNarrowest = 1e-3;

std::string shortText(double x) { return std::to_string(x).substr(0, 6); }

/// How the quadrilaterals of a grid are cut in two.
enum class Diagonals : std::uint8_t { Rising, Falling, Alternating };

/// A grid of points, closed or open in both directions. `columns` and `rows` count quadrilaterals.
struct Grid {
  Index columns{1}, rows{1};
  bool closedColumns{false}, closedRows{false};

  Index width() const { return closedColumns ? columns : columns + 1; }
  Index height() const { return closedRows ? rows : rows + 1; }
};

/// The surface over a grid; `place` takes shares of its width and height, from 0 to 1. Row r,
/// column c is the vertex r × width + c.
Shape gridShape(const Grid& grid, Diagonals diagonals,
                const std::function<Vec3(double, double)>& place) {
  Shape shape;
  for (Index r = 0; r < grid.height(); ++r) {
    for (Index c = 0; c < grid.width(); ++c) {
      const Vec3 p =
          place(static_cast<double>(c) / grid.columns, static_cast<double>(r) / grid.rows);
      shape.add(p.x, p.y, p.z);
    }
  }
  for (Index r = 0; r < grid.rows; ++r) {
    for (Index c = 0; c < grid.columns; ++c) {
      const Index up = (r + 1) % grid.height(), along = (c + 1) % grid.width();
      const Index a = r * grid.width() + c, b = r * grid.width() + along;
      const Index d = up * grid.width() + c, e = up * grid.width() + along;
      const bool rising = diagonals == Diagonals::Rising ||
                          (diagonals == Diagonals::Alternating && (r + c) % 2 == 0);
      if (rising) {
        shape.face(a, b, e);
        shape.face(a, e, d);
      } else {
        shape.face(a, b, d);
        shape.face(b, e, d);
      }
    }
  }
  return shape;
}

/// A new vertex closes the ring of `count` vertices from `first` on; `outwards`: the ring runs
/// counter-clockwise as seen from it.
void cap(Shape& shape, Index first, Index count, Vec3 place, bool outwards) {
  const Index centre = shape.add(place.x, place.y, place.z);
  for (Index i = 0; i < count; ++i) {
    const Index a = first + i, b = first + (i + 1) % count;
    if (outwards) {
      shape.face(centre, a, b);
    } else {
      shape.face(centre, b, a);
    }
  }
}

Vec3 centreOf(const Shape& shape, Index first, Index count) {
  Vec3 sum{0, 0, 0};
  for (Index i = first; i < first + count; ++i) {
    sum =
        sum + Vec3{shape.positions[3 * i], shape.positions[3 * i + 1], shape.positions[3 * i + 2]};
  }
  return (1.0 / count) * sum;
}

/// A profile in the plane, by share of the way round: a regular polygon, an oval, a gear.
std::function<Vec3(double)> profile(Random& random, Index& sides, std::string& history) {
  const double radius = 0.3 + random();
  switch (random.below(4)) {
    case 0: {  // a gear
      const Index teeth = 2 + random.below(5);
      sides = 4 * teeth;
      const double depth = 0.2 + 0.5 * random();
      history += "gear of " + std::to_string(teeth) + " teeth";
      return [=](double t) {
        const auto corner = static_cast<Index>(std::lround(t * sides));
        const double r = radius * (corner % 4 < 2 ? 1 : 1 - depth);
        return Vec3{r * std::cos(2 * M_PI * t), r * std::sin(2 * M_PI * t), 0};
      };
    }
    case 1: {  // an oval
      const double stretch = 1 + random();
      history += "oval of " + std::to_string(sides);
      return [=](double t) {
        return Vec3{stretch * radius * std::cos(2 * M_PI * t), radius * std::sin(2 * M_PI * t), 0};
      };
    }
    default:
      history += "polygon of " + std::to_string(sides);
      return [=](double t) {
        return Vec3{radius * std::cos(2 * M_PI * t), radius * std::sin(2 * M_PI * t), 0};
      };
  }
}

/// A straight, sheared or bent tube over a profile; open, or with flat caps.
Shape tubeShape(Random& random, Diagonals diagonals, std::string& history) {
  Index sides = 3 + random.below(38);
  const auto section = profile(random, sides, history);
  const Index rings = 1 + random.below(std::max<Index>(1, std::min<Index>(6, 200 / sides)));
  const double height = 0.2 + 8 * random();
  const double shear = random() < 0.3 ? random() : 0;
  const double bend = random() < 0.4 ? 0.2 + 2.5 * random() : 0;
  const double taper = random() < 0.2 ? 0.9 * random() : 0;
  history += ", tube of " + std::to_string(rings) + " rings, height " + shortText(height);
  if (shear > 0) history += ", sheared";
  if (bend > 0) history += ", bent";
  if (taper > 0) history += ", tapered";
  Shape shape = gridShape({sides, rings, true, false}, diagonals, [&](double across, double along) {
    Vec3 p = section(across);
    p = (1 - taper * along) * p;
    if (bend > 0) {
      const double around = 3 + height, angle = bend * along;
      return Vec3{(around + p.x) * std::cos(angle), p.y, (around + p.x) * std::sin(angle)};
    }
    return Vec3{p.x + shear * height * along, p.y, height * along};
  });
  const bool closed = random() < 0.5;
  if (closed) {
    history += ", closed";
    // A bent tube turns the other way round.
    const bool turned = bend > 0;
    const Vec3 bottom = centreOf(shape, 0, sides), top = centreOf(shape, rings * sides, sides);
    cap(shape, 0, sides, bottom, false);
    cap(shape, rings * sides, sides, top, true);
    if (turned) return shape;
  }
  return shape;
}

Shape torusShape(Random& random, Diagonals diagonals, std::string& history) {
  const Index around = 3 + random.below(14);
  const Index across = 3 + random.below(std::min<Index>(11, kMostVertices / around - 3));
  const std::array<double, 4> radii = {6, 3, 2, 1.5 + 4 * random()};
  const double radius = radii[random.below(4)], tube = random() < 0.6 ? 1 : 0.2 + random();
  history += "torus of " + std::to_string(around) + " sections of " + std::to_string(across);
  return gridShape({across, around, true, true}, diagonals, [&](double v, double u) {
    const double r = radius + tube * std::cos(2 * M_PI * v);
    return Vec3{r * std::cos(2 * M_PI * u), r * std::sin(2 * M_PI * u),
                tube * std::sin(2 * M_PI * v)};
  });
}

/// A surface of revolution about the z axis: a cone, a double cone, a sphere, a vase.
Shape revolvedShape(Random& random, Diagonals diagonals, std::string& history) {
  const Index sides = 3 + random.below(18);
  const Index rings = 1 + random.below(std::min<Index>(9, kMostVertices / sides - 1));
  std::function<std::pair<double, double>(double)> outline;  // radius and height, t in (0, 1)
  const double size = 0.3 + 3 * random(), height = 0.2 + 4 * random();
  switch (random.below(4)) {
    case 0:
      history += "cone";
      outline = [=](double t) { return std::pair(size * (1 - t), height * t); };
      break;
    case 1:
      history += "double cone";
      outline = [=](double t) {
        return std::pair(size * (1 - std::fabs(2 * t - 1)), height * (t - 0.5));
      };
      break;
    case 2:
      history += "sphere";
      outline = [=](double t) {
        return std::pair(size * std::sin(M_PI * t), -size * std::cos(M_PI * t));
      };
      break;
    default: {
      history += "vase";
      const double waist = 0.1 + 0.8 * random(), waves = 1 + random.below(3);
      outline = [=](double t) {
        return std::pair(size * (1 - waist / 2 + waist / 2 * std::cos(2 * M_PI * waves * t)),
                         height * t);
      };
    }
  }
  history += " of " + std::to_string(sides) + " sides in " + std::to_string(rings) + " rings";
  const bool open = random() < 0.4;
  const double low = open ? 0.1 + 0.3 * random() : 1.0 / (rings + 2), high = 1 - low;
  Shape shape = gridShape({sides, rings, true, false}, diagonals, [&](double across, double along) {
    const auto [r, z] = outline(low + along * (high - low));
    return Vec3{r * std::cos(2 * M_PI * across), r * std::sin(2 * M_PI * across), z};
  });
  if (!open) {
    history += ", closed";
    const bool flat = random() < 0.5;
    cap(shape, 0, sides, {0, 0, outline(flat ? low : 0).second}, false);
    cap(shape, rings * sides, sides, {0, 0, outline(flat ? high : 1).second}, true);
  }
  return shape;
}

/// A flat or rolled sheet with a boundary.
Shape sheetShape(Random& random, Diagonals diagonals, std::string& history) {
  const Index columns = 1 + random.below(10), rows = 1 + random.below(10);
  const double roll = random() < 0.5 ? 0 : 0.5 + 5 * random();
  history += "sheet of " + std::to_string(columns) + " by " + std::to_string(rows);
  if (roll > 0) history += ", rolled";
  return gridShape({columns, rows, false, false}, diagonals, [&](double u, double v) {
    if (roll == 0) return Vec3{u * columns, v * rows, 0};
    const double radius = columns / roll;
    return Vec3{radius * std::cos(roll * u), radius * std::sin(roll * u), v * rows};
  });
}

Shape boxShape(Random& random, std::string& history) {
  const Index x = 1 + random.below(3), y = 1 + random.below(3), z = 1 + random.below(8);
  history +=
      "box of " + std::to_string(x) + " by " + std::to_string(y) + " by " + std::to_string(z);
  const double b = random() < 0.5 ? y : 0.1 + random(), c = random() < 0.5 ? z : 0.1 + 4 * random();
  return box(x, b, c, x, y, z);
}

/// Two copies of a shape, the second mirrored in the plane of a boundary ring or face and joined
/// with the first along it: the shape and its mirror image share the vertices on the plane.
Shape doubled(const Shape& shape) {
  double lowest = shape.positions[2];
  for (Index v = 0; v < shape.vertexCount(); ++v)
    lowest = std::min(lowest, shape.positions[3 * v + 2]);
  const auto isLow = [&](Index v) { return shape.positions[3 * v + 2] < lowest + 1e-9; };
  Shape both;
  both.positions = shape.positions;
  std::vector<Index> image(shape.vertexCount());
  for (Index v = 0; v < shape.vertexCount(); ++v) {
    image[v] = isLow(v) ? v
                        : both.add(shape.positions[3 * v], shape.positions[3 * v + 1],
                                   2 * lowest - shape.positions[3 * v + 2]);
  }
  for (std::size_t t = 0; t < shape.triangles.size(); t += 3) {
    const Index a = shape.triangles[t], b = shape.triangles[t + 1], c = shape.triangles[t + 2];
    if (isLow(a) && isLow(b) && isLow(c)) continue;  // a face in the plane is inside now
    both.face(a, b, c);
    both.face(image[c], image[b], image[a]);
  }
  return withoutLoneVertices(both);
}

/// Boxes of a grid that share faces: crosses, stairs, frames, blocks with holes.
Shape boxesShape(Random& random, std::string& history) {
  constexpr int kMostCells = 4;
  std::array<std::vector<double>, 3> planes;
  for (std::vector<double>& along : planes) {
    const Index count = 1 + random.below(kMostCells);
    const bool isEven = random() < 0.6;
    along = {0};
    for (Index i = 0; i < count; ++i) along.push_back(along.back() + (isEven ? 1 : 0.2 + random()));
  }
  const auto cells = [&](std::size_t axis) { return static_cast<Index>(planes[axis].size() - 1); };
  std::set<std::array<int, 3>> filled;
  const Index most = 2 + random.below(14);
  std::array<int, 3> cell{};
  for (std::size_t k = 0; k < 3; ++k) cell[k] = static_cast<int>(random.below(cells(k)));
  for (Index step = 0; step < most; ++step) {
    filled.insert(cell);
    const std::size_t axis = random.below(3);
    cell[axis] += random() < 0.5 ? -1 : 1;
    cell[axis] = std::clamp(cell[axis], 0, static_cast<int>(cells(axis)) - 1);
  }
  history += "union of " + std::to_string(filled.size()) + " boxes";
  const Shape shape = blocks(planes[0], planes[1], planes[2], [&](int i, int j, int k) {
    return filled.count({i, j, k}) > 0;
  });
  return random() < 0.3 && 4 * shape.vertexCount() < kMostVertices ? subdivided(shape) : shape;
}

/// Prisms of one axis and one number of sides, one on the other: a stepped shaft, closed.
Shape shaftShape(Random& random, std::string& history) {
  const Index sides = 3 + random.below(14), prisms = 2 + random.below(3);
  std::vector<std::pair<double, double>> outline{{0, 0}};
  double radius = 0.3 + random(), height = 0;
  for (Index i = 0; i < prisms; ++i) {
    outline.emplace_back(radius, height);
    height += 0.1 + 3 * random();
    outline.emplace_back(radius, height);
    radius *= random() < 0.5 ? 0.3 + 0.6 * random() : 1.1 + 2 * random();
  }
  outline.emplace_back(0, height);
  history += "union of " + std::to_string(prisms) + " prisms of " + std::to_string(sides);
  return revolved(outline, sides);
}

double rounded(double x, double step) { return std::round(x / step) * step; }

/// Turns, scales, moves and rounds.
void place(Shape& shape, Random& random, std::string& history) {
  // A random rotation, by a unit quaternion.
  std::array<double, 4> q{};
  double square = 0;
  for (double& component : q) {
    component = random() - 0.5;
    square += component * component;
  }
  for (double& component : q) component /= std::sqrt(square);
  const bool isTurned = random() < 0.85;
  const double scale =
      random() < 0.6 ? 1 : std::pow(10.0, static_cast<double>(random.below(13)) - 6);
  const double offset = random() < 0.6 ? 0 : std::pow(10.0, random.below(7)) * scale;
  const Vec3 shift{offset * (random() - 0.5), offset * (random() - 0.5), offset * (random() - 0.5)};
  const Index decimals = 2 + random.below(12);  // 13: none; 12 and more: single precision
  const double step = std::pow(10.0, -static_cast<double>(decimals)) * scale;
  for (Index v = 0; v < shape.vertexCount(); ++v) {
    double* p = &shape.positions[3 * v];
    Vec3 x{p[0], p[1], p[2]};
    if (isTurned) {
      const Vec3 u{q[1], q[2], q[3]};
      const Vec3 t = 2 * cross(u, x);
      x = x + q[0] * t + cross(u, t);
    }
    x = scale * x + shift;
    for (double* c : {&x.x, &x.y, &x.z}) {
      if (decimals == 13) {
        *c = static_cast<double>(static_cast<float>(*c));
      } else {
        *c = rounded(*c, step);
      }
    }
    p[0] = x.x, p[1] = x.y, p[2] = x.z;
  }
  history += isTurned ? ", turned" : "";
  history += ", scale " + std::to_string(scale) + ", offset " + std::to_string(offset);
  history += decimals == 13 ? ", single precision" : ", " + std::to_string(decimals) + " decimals";
}

Shape singleBody(Random& random, std::string& history) {
  const auto diagonals = static_cast<Diagonals>(random.below(3));
  Shape shape;
  switch (random.below(8)) {
    case 0:
    case 1:
    case 2:
      shape = tubeShape(random, diagonals, history);
      break;
    case 3:
    case 4:
      shape = torusShape(random, diagonals, history);
      break;
    case 5:
      shape = revolvedShape(random, diagonals, history);
      break;
    case 6:
      shape = sheetShape(random, diagonals, history);
      break;
    default:
      shape = boxShape(random, history);
      break;
  }
  if (random() < 0.1) {
    shape = doubled(shape);
    history += ", doubled";
  }
  if (random() < 0.1 && 4 * shape.vertexCount() < kMostVertices) {
    shape = subdivided(shape);
    history += ", subdivided";
  }
  return shape;
}

}  // namespace

RegularShape regularShape(std::uint64_t seed) {
  Random random(seed + 0x5eed);
  for (int i = 0; i < 3; ++i) random();  // seeds near each other begin alike
  for (;;) {
    RegularShape result;
    std::string& history = result.history;
    Shape& shape = result.shape;
    if (seed >= kFirstUnion) {
      shape = random() < 0.6 ? boxesShape(random, history) : shaftShape(random, history);
    } else {
      shape = singleBody(random, history);
    }
    place(shape, random, history);
    if (shape.vertexCount() <= kMostVertices && isSurface(shape, kNarrowest) &&
        shape.mesh(OpenEdges::Boundary).componentCount() == 1) {
      return result;
    }
  }
}

}  // namespace girth::test
