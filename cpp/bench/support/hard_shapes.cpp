#include "support/hard_shapes.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>

namespace girth::bench {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

struct Point {
  double x, y, z;
};

Index add(TriangleSoup& soup, const Point& p) {
  soup.positions.insert(soup.positions.end(), {p.x, p.y, p.z});
  return static_cast<Index>(soup.positions.size() / 3 - 1);
}

void face(TriangleSoup& soup, Index a, Index b, Index c) {
  soup.triangles.insert(soup.triangles.end(), {a, b, c});
}

/// Points of a function of two shares in [0, 1], joined by two triangles a rectangle. Preparing
/// welds what meets.
void addGrid(TriangleSoup& soup, Index across, Index along,
             const std::function<Point(double, double)>& at) {
  const auto first = static_cast<Index>(soup.positions.size() / 3);
  for (Index i = 0; i <= across; ++i) {
    for (Index j = 0; j <= along; ++j) add(soup, at(double(i) / across, double(j) / along));
  }
  for (Index i = 0; i < across; ++i) {
    for (Index j = 0; j < along; ++j) {
      const Index a = first + i * (along + 1) + j, b = a + along + 1;
      face(soup, a, b, b + 1);
      face(soup, a, b + 1, a + 1);
    }
  }
}

/// Exact at the seam, so that it is welded.
double turnCosine(double share) { return share == 1 ? 1 : std::cos(kTurn * share); }
double turnSine(double share) { return share == 1 ? 0 : std::sin(kTurn * share); }

/// A curve of radius and height, turned round the z axis.
TriangleSoup revolved(Index around, Index along,
                      const std::function<std::pair<double, double>(double)>& curve) {
  TriangleSoup soup;
  addGrid(soup, around, along, [&](double u, double v) {
    const auto [radius, height] = curve(v);
    return Point{radius * turnCosine(u), radius * turnSine(u), height};
  });
  return soup;
}

TriangleSoup sphere(Index around, Index along, double x = 1, double y = 1, double z = 1) {
  TriangleSoup soup;
  addGrid(soup, around, along, [&](double u, double v) {
    const double radius = v == 0 || v == 1 ? 0 : std::sin(std::numbers::pi * v);
    return Point{x * radius * turnCosine(u), y * radius * turnSine(u),
                 -z * std::cos(std::numbers::pi * v)};
  });
  return soup;
}

TriangleSoup torus(double major, double minor, Index around, Index across, double bumps = 0) {
  TriangleSoup soup;
  addGrid(soup, around, across, [&](double u, double v) {
    const double r = minor * (1 + bumps * turnSine(std::fmod(3 * u, 1.0)));
    const double radius = major + r * turnCosine(v);
    return Point{radius * turnCosine(u), radius * turnSine(u), r * turnSine(v)};
  });
  return soup;
}

/// Six sides of a block, each of so many rectangles.
TriangleSoup block(double a, double b, double c, Index na, Index nb, Index nc, double shift = 0) {
  TriangleSoup soup;
  const auto side = [&](Index n, Index m, const std::function<Point(double, double)>& at) {
    addGrid(soup, n, m, [&](double u, double v) {
      const Point p = at(u, v);
      return Point{p.x + shift, p.y + shift, p.z + shift};
    });
  };
  side(nb, na, [&](double u, double v) { return Point{a * v, b * u, 0}; });
  side(na, nb, [&](double u, double v) { return Point{a * u, b * v, c}; });
  side(na, nc, [&](double u, double v) { return Point{a * u, 0, c * v}; });
  side(nc, na, [&](double u, double v) { return Point{a * v, b, c * u}; });
  side(nc, nb, [&](double u, double v) { return Point{0, b * v, c * u}; });
  side(nb, nc, [&](double u, double v) { return Point{a, b * u, c * v}; });
  return soup;
}

/// A plate without thickness: two sheets that share their rim.
TriangleSoup doubledPlate(Index n, const std::function<Point(double, double)>& at) {
  TriangleSoup soup;
  addGrid(soup, n, n, at);
  const auto inner = static_cast<Index>(soup.positions.size() / 3);
  // The other sheet has corners of its own inside, a hair above, lest its faces be taken for
  // copies.
  TriangleSoup other;
  addGrid(other, n, n, [&](double u, double v) {
    Point p = at(u, v);
    const bool isRim = u == 0 || u == 1 || v == 0 || v == 1;
    if (!isRim) p.z += 1e-9;
    return p;
  });
  soup.positions.insert(soup.positions.end(), other.positions.begin(), other.positions.end());
  for (std::size_t i = 0; i < other.triangles.size(); i += 3) {
    face(soup, inner + other.triangles[i], inner + other.triangles[i + 2],
         inner + other.triangles[i + 1]);
  }
  return soup;
}

TriangleSoup doubledNeedle(double width, double length) {
  TriangleSoup soup;
  add(soup, {0, 0, 0});
  add(soup, {length, 0, 0});
  add(soup, {0.3 * length, width, 0});
  add(soup, {0.5 * length, width / 3, 0});
  face(soup, 0, 1, 2);
  face(soup, 0, 3, 1);
  face(soup, 0, 2, 3);
  face(soup, 1, 3, 2);
  return soup;
}

/// A fan round a pole, whose rim rises and falls `waves` times; where it does, the pole is a
/// saddle.
TriangleSoup fan(Index triangles, double height, int waves, bool closed) {
  TriangleSoup soup;
  const Index pole = add(soup, {0, 0, height});
  const Index base = closed ? add(soup, {0, 0, -height - 0.1}) : pole;
  const Index first = static_cast<Index>(soup.positions.size() / 3);
  for (Index i = 0; i < triangles; ++i) {
    const double u = double(i) / triangles;
    add(soup,
        {std::cos(kTurn * u), std::sin(kTurn * u), waves > 0 ? std::sin(kTurn * waves * u) : 0});
  }
  for (Index i = 0; i < triangles; ++i) {
    const Index a = first + i, b = first + (i + 1) % triangles;
    face(soup, pole, a, b);
    if (closed) face(soup, base, b, a);
  }
  return soup;
}

void append(TriangleSoup& soup, const TriangleSoup& other, double scale, double shift) {
  const auto first = static_cast<Index>(soup.positions.size() / 3);
  for (const double x : other.positions) soup.positions.push_back(scale * x + shift);
  for (const Index v : other.triangles) soup.triangles.push_back(first + v);
}

TriangleSoup together(const TriangleSoup& one, const TriangleSoup& two, double scale,
                      double shift) {
  TriangleSoup soup = one;
  append(soup, two, scale, shift);
  return soup;
}

/// A sphere whose points are moved in and out, the same everywhere.
TriangleSoup rough(TriangleSoup soup, double amount) {
  std::uint64_t seed = 1;
  // Welded places move alike: the random number is drawn of the place.
  for (std::size_t i = 0; i < soup.positions.size(); i += 3) {
    const double key = std::round(1e6 * soup.positions[i]) +
                       31 * std::round(1e6 * soup.positions[i + 1]) +
                       977 * std::round(1e6 * soup.positions[i + 2]);
    seed = static_cast<std::uint64_t>(static_cast<std::int64_t>(key)) * 6364136223846793005u +
           1442695040888963407u;
    seed = (seed ^ (seed >> 29)) * 0x9E3779B97F4A7C15u;
    const double factor = 1 + amount * (static_cast<double>(seed >> 11) * 0x1p-53 - 0.5);
    for (std::size_t k = 0; k < 3; ++k) soup.positions[i + k] *= factor;
  }
  return soup;
}

std::pair<double, double> tube(double radius, double length, double v) {
  // Caps in the first and last tenth.
  if (v <= 0.1) return {v == 0 ? 0 : radius * v / 0.1, 0};
  if (v >= 0.9) return {v == 1 ? 0 : radius * (1 - v) / 0.1, length};
  return {radius, length * (v - 0.1) / 0.8};
}

}  // namespace

std::vector<HardShape> smoothShapes() {
  return {{"smooth: torus with bumps", torus(3, 1, 100, 40, 0.3)},
          {"smooth: torus", torus(3, 1.01, 90, 31)},
          {"smooth: ellipsoid", rough(sphere(60, 50, 1, 1.4, 2.1), 0.002)},
          {"smooth: rough sphere", rough(sphere(60, 50), 0.1)},
          {"smooth: long rod",
           rough(revolved(24, 150, [](double v) { return tube(1, 20, v); }), 0.01)}};
}

std::vector<HardShape> hardShapes() {
  const auto plane = [](double width, double height) {
    return [=](double u, double v) { return Point{width * u, height * v, 0}; };
  };
  const auto disk = [](double u, double v) {
    const double x = 2 * u - 1, y = 2 * v - 1;
    return Point{x * std::sqrt(1 - y * y / 2), y * std::sqrt(1 - x * x / 2), 0};
  };
  return {
      {"doubled needle, width 1e-5", doubledNeedle(1e-5, 1)},
      {"doubled needle, width 1e-9", doubledNeedle(1e-9, 1)},
      {"doubled needle, 0.16 by 1.4e-6", doubledNeedle(1.4e-6, 0.16)},
      {"doubled triangle of four faces", doubledNeedle(0.8, 1)},
      {"needle beside a sphere", together(sphere(40, 30), doubledNeedle(1e-5, 1), 0.1, 3)},
      {"doubled square plate", doubledPlate(24, plane(1, 1))},
      {"doubled long plate", doubledPlate(24, plane(20, 1))},
      {"doubled disk", doubledPlate(24, disk)},
      {"cone of 600 sides", fan(600, 2, 0, true)},
      {"cone of 10,000 sides", fan(10'000, 2, 0, true)},
      {"flat cone of 5,000 sides", fan(5'000, 0.01, 0, true)},
      {"open fan of 10,000 triangles", fan(10'000, 0.5, 0, false)},
      {"saddle of 3,000 triangles", fan(3'000, 0, 7, false)},
      {"sphere with poles of valence 100", sphere(100, 50)},
      {"sphere with poles of valence 1,000", sphere(1'000, 10)},
      {"sphere, stretched 1,000 times", sphere(40, 40, 1, 1, 1'000)},
      {"sphere, flattened 1,000 times", sphere(40, 40, 1, 1, 1e-3)},
      {"rod of revolution", revolved(64, 100, [](double v) { return tube(1, 30, v); })},
      {"cylinder of 720 sides", revolved(720, 10, [](double v) { return tube(1, 3, v); })},
      {"torus of few and many sides", torus(3, 1, 500, 5)},
      {"torus of many and few sides", torus(3, 1, 5, 500)},
      {"torus, thin", torus(1, 0.01, 300, 12)},
      {"cube of 12 faces", block(1, 1, 1, 1, 1, 1)},
      {"cube of 9,600 faces", block(1, 1, 1, 40, 40, 40)},
      {"cube, 1e8 from the origin", block(1, 1, 1, 20, 20, 20, 1e8)},
      {"plate, 1e-7 thick", block(1, 1, 1e-7, 30, 30, 1)},
      {"plate, 1e-3 thick, in strips", block(1, 1, 1e-3, 400, 1, 1)},
      {"tube, 1e-5 wide, one edge long", block(1, 1e-5, 1e-5, 1, 1, 1)},
      {"bar, 1,000 times as long as wide", block(1'000, 1, 1, 300, 2, 2)},
      {"edges of 1e-7 beside 1",
       together(block(1, 1, 1, 2, 2, 2), block(1, 1, 1, 30, 30, 30), 1e-7, 2)},
      {"tip of 1e-7 on a cone", revolved(60, 60,
                                         [](double v) {
                                           // Rings that shrink geometrically.
                                           const double r = v == 1 ? 0 : std::pow(1e-7, v);
                                           return std::pair(v == 0 ? 0.0 : r,
                                                            v == 0 ? -0.01 : 2 * (1 - r));
                                         })},
      {"spheres of very unequal size", together(sphere(60, 50), sphere(60, 50), 1e-6, 3)},
      {"rough sphere", rough(sphere(60, 50), 0.8)},
  };
}

}  // namespace girth::bench
