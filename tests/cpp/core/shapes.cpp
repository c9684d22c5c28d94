#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "mesh/vector.h"

namespace girth::test {

namespace {

Vec3 at(const Shape& shape, Index v) {
  return {shape.positions[3 * v], shape.positions[3 * v + 1], shape.positions[3 * v + 2]};
}

void pushToSphere(Shape& shape) {
  for (Index v = 0; v < shape.vertexCount(); ++v) {
    const double length = norm(at(shape, v));
    for (Index k = 0; k < 3; ++k) shape.positions[3 * v + k] /= length;
  }
}

/// Two triangles for a quadrilateral. In braces its corners, which get their numbers there, follow
/// each other with every compiler.
void quad(Shape& shape, const std::array<Index, 4>& corners) {
  const auto [a, b, c, d] = corners;
  shape.face(a, b, c);
  shape.face(a, c, d);
}

}  // namespace

Index Shape::add(double x, double y, double z) {
  positions.insert(positions.end(), {x, y, z});
  return vertexCount() - 1;
}

void Shape::face(Index a, Index b, Index c) { triangles.insert(triangles.end(), {a, b, c}); }

SurfaceMesh Shape::mesh(OpenEdges openEdges) const {
  auto result = SurfaceMesh::fromArrays(positions, triangles, openEdges);
  if (!result) {
    ADD_FAILURE() << result.error().message;
    return tetrahedron().mesh();
  }
  return std::move(result).value();
}

double Random::operator()() {
  state_ ^= state_ << 13;
  state_ ^= state_ >> 7;
  state_ ^= state_ << 17;
  return static_cast<double>(state_ >> 11) * 0x1p-53;
}

Shape prism(const std::vector<double>& polygon, double height, Index rings) {
  Shape shape;
  const auto corners = static_cast<Index>(polygon.size() / 2);
  double cx = 0, cy = 0;
  for (Index i = 0; i < corners; ++i) {
    cx += polygon[2 * i] / corners;
    cy += polygon[2 * i + 1] / corners;
  }
  for (Index ring = 0; ring <= rings; ++ring) {
    for (Index i = 0; i < corners; ++i) {
      shape.add(polygon[2 * i], polygon[2 * i + 1], height * ring / rings);
    }
  }
  for (Index ring = 0; ring < rings; ++ring) {
    for (Index i = 0; i < corners; ++i) {
      const Index j = (i + 1) % corners, low = ring * corners, high = low + corners;
      quad(shape, {low + i, low + j, high + j, high + i});
    }
  }
  const Index bottom = shape.add(cx, cy, 0), top = shape.add(cx, cy, height);
  for (Index i = 0; i < corners; ++i) {
    const Index j = (i + 1) % corners;
    shape.face(bottom, j, i);
    shape.face(top, rings * corners + i, rings * corners + j);
  }
  return shape;
}

std::vector<double> regularPolygon(Index sides, double side, Index parts) {
  const double radius = side / (2 * std::sin(M_PI / sides));
  std::vector<double> polygon;
  const auto corner = [&](Index i) {
    const double angle = 2 * M_PI * (i % sides) / sides;
    return std::pair(radius * std::cos(angle), radius * std::sin(angle));
  };
  for (Index i = 0; i < sides; ++i) {
    const auto [ax, ay] = corner(i);
    const auto [bx, by] = corner(i + 1);
    for (Index k = 0; k < parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      polygon.insert(polygon.end(), {ax + t * (bx - ax), ay + t * (by - ay)});
    }
  }
  return polygon;
}

Shape bentRod(Index corners, Index rings) {
  Shape shape = prism(regularPolygon(corners, 3.6 / corners), 20, rings);
  for (Index v = 0; v < shape.vertexCount(); ++v) {
    double* p = &shape.positions[3 * v];
    const double angle = p[2] / 20 * 330 * M_PI / 180, radius = 3.5 + p[0];
    p[0] = radius * std::cos(angle);
    p[2] = radius * std::sin(angle);
  }
  return shape;
}

Shape bumpyRod(Index around, Index rings, double height) {
  Shape shape = prism(regularPolygon(around, 2 * std::sin(M_PI / around)), height, rings);
  for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
    double &x = shape.positions[i], &y = shape.positions[i + 1];
    const double z = shape.positions[i + 2], angle = std::atan2(y, x);
    const double end = 0.1 + 0.9 * std::sqrt(1 - std::pow(std::fabs(2 * z / height - 1), 8));
    const double bumps = 0.3 * std::sin(3 * angle + 1 + 0.7 * std::sin(z)) * std::sin(2 * z + 2) +
                         0.15 * std::sin(6 * angle + 1.7 * z);
    x *= end * (1 + bumps);
    y *= end * (1 + bumps);
  }
  return shape;
}

Shape pyramid(Index sides, double apexAngle, Index rings) {
  Shape shape;
  // Edges of length 1 from the apex; each face has its share of the apex angle.
  const double base = 2 * std::sin(apexAngle / sides / 2);
  const double radius = base / (2 * std::sin(M_PI / sides));
  const double height = std::sqrt(1 - radius * radius);
  shape.add(0, 0, height);
  for (Index ring = 1; ring <= rings; ++ring) {
    const double t = static_cast<double>(ring) / rings;
    for (Index i = 0; i < sides; ++i) {
      const double angle = 2 * M_PI * i / sides;
      shape.add(t * radius * std::cos(angle), t * radius * std::sin(angle), height * (1 - t));
    }
  }
  for (Index i = 0; i < sides; ++i) {
    const Index j = (i + 1) % sides;
    shape.face(0, 1 + i, 1 + j);
    for (Index ring = 0; ring + 1 < rings; ++ring) {
      const Index high = 1 + ring * sides, low = high + sides;
      quad(shape, {high + i, low + i, low + j, high + j});
    }
  }
  const Index bottom = shape.add(0, 0, 0), last = 1 + (rings - 1) * sides;
  for (Index i = 0; i < sides; ++i) shape.face(bottom, last + (i + 1) % sides, last + i);
  return shape;
}

Shape box(double a, double b, double c, Index nx, Index ny, Index nz) {
  Shape shape;
  std::map<std::array<Index, 3>, Index> numbers;
  const auto vertex = [&](Index i, Index j, Index k) {
    const auto [it, isNew] = numbers.try_emplace({i, j, k}, shape.vertexCount());
    if (isNew) shape.add(a * i / nx, b * j / ny, c * k / nz);
    return it->second;
  };
  for (Index i = 0; i < nx; ++i) {
    for (Index j = 0; j < ny; ++j) {
      quad(shape,
           {vertex(i, j, 0), vertex(i, j + 1, 0), vertex(i + 1, j + 1, 0), vertex(i + 1, j, 0)});
      quad(shape, {vertex(i, j, nz), vertex(i + 1, j, nz), vertex(i + 1, j + 1, nz),
                   vertex(i, j + 1, nz)});
    }
  }
  for (Index i = 0; i < nx; ++i) {
    for (Index k = 0; k < nz; ++k) {
      quad(shape,
           {vertex(i, 0, k), vertex(i + 1, 0, k), vertex(i + 1, 0, k + 1), vertex(i, 0, k + 1)});
      quad(shape, {vertex(i, ny, k), vertex(i, ny, k + 1), vertex(i + 1, ny, k + 1),
                   vertex(i + 1, ny, k)});
    }
  }
  for (Index j = 0; j < ny; ++j) {
    for (Index k = 0; k < nz; ++k) {
      quad(shape,
           {vertex(0, j, k), vertex(0, j, k + 1), vertex(0, j + 1, k + 1), vertex(0, j + 1, k)});
      quad(shape, {vertex(nx, j, k), vertex(nx, j + 1, k), vertex(nx, j + 1, k + 1),
                   vertex(nx, j, k + 1)});
    }
  }
  return shape;
}

Shape torus(double R, double r, Index around, Index across) {
  Shape shape;
  for (Index i = 0; i < around; ++i) {
    const double u = 2 * M_PI * i / around;
    for (Index j = 0; j < across; ++j) {
      const double v = 2 * M_PI * j / across;
      const double rho = R + r * std::cos(v);
      shape.add(rho * std::cos(u), rho * std::sin(u), r * std::sin(v));
    }
  }
  for (Index i = 0; i < around; ++i) {
    const Index in = (i + 1) % around;
    for (Index j = 0; j < across; ++j) {
      const Index jn = (j + 1) % across;
      quad(shape, {i * across + j, in * across + j, in * across + jn, i * across + jn});
    }
  }
  return shape;
}

Shape octasphere(Index levels) {
  Shape shape;
  for (const double s : {1.0, -1.0}) {
    shape.add(s, 0, 0);
    shape.add(0, s, 0);
    shape.add(0, 0, s);
  }
  for (const Index x : {0u, 3u}) {
    for (const Index y : {1u, 4u}) {
      for (const Index z : {2u, 5u}) {
        const bool even = ((x + y + z) % 2 == 1) == (0 + 1 + 2) % 2;
        even ? shape.face(x, y, z) : shape.face(x, z, y);
      }
    }
  }
  for (Index i = 0; i < levels; ++i) {
    shape = subdivided(shape);
    pushToSphere(shape);
  }
  return shape;
}

Shape icosphere(Index levels) {
  Shape shape;
  const double g = (1 + std::sqrt(5.0)) / 2;
  for (const auto& p : std::vector<std::array<double, 3>>{{-1, g, 0},
                                                          {1, g, 0},
                                                          {-1, -g, 0},
                                                          {1, -g, 0},
                                                          {0, -1, g},
                                                          {0, 1, g},
                                                          {0, -1, -g},
                                                          {0, 1, -g},
                                                          {g, 0, -1},
                                                          {g, 0, 1},
                                                          {-g, 0, -1},
                                                          {-g, 0, 1}}) {
    shape.add(p[0], p[1], p[2]);
  }
  shape.triangles = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                     4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                     6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  pushToSphere(shape);
  for (Index i = 0; i < levels; ++i) {
    shape = subdivided(shape);
    pushToSphere(shape);
  }
  return shape;
}

Shape tetrahedron() {
  Shape shape;
  shape.positions = {1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};
  shape.triangles = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  return shape;
}

Shape plate(Index holes) { return plate(holes, holes); }

Shape plate(Index holesAcross, Index holesAlong) {
  Shape shape;
  const Index nx = 2 * holesAcross + 1, ny = 2 * holesAlong + 1;
  std::map<std::array<Index, 3>, Index> numbers;
  const auto vertex = [&](Index i, Index j, Index k) {
    const auto [it, isNew] = numbers.try_emplace({i, j, k}, shape.vertexCount());
    if (isNew) shape.add(i, j, 0.5 * k);
    return it->second;
  };
  const auto solid = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < static_cast<int>(nx) && j < static_cast<int>(ny) &&
           !(i % 2 == 1 && j % 2 == 1);
  };
  for (Index i = 0; i < nx; ++i) {
    for (Index j = 0; j < ny; ++j) {
      const int x = static_cast<int>(i), y = static_cast<int>(j);
      if (!solid(x, y)) continue;
      quad(shape,
           {vertex(i, j, 0), vertex(i, j + 1, 0), vertex(i + 1, j + 1, 0), vertex(i + 1, j, 0)});
      quad(shape,
           {vertex(i, j, 1), vertex(i + 1, j, 1), vertex(i + 1, j + 1, 1), vertex(i, j + 1, 1)});
      if (!solid(x, y - 1)) {
        quad(shape, {vertex(i, j, 0), vertex(i + 1, j, 0), vertex(i + 1, j, 1), vertex(i, j, 1)});
      }
      if (!solid(x, y + 1)) {
        quad(shape, {vertex(i, j + 1, 0), vertex(i, j + 1, 1), vertex(i + 1, j + 1, 1),
                     vertex(i + 1, j + 1, 0)});
      }
      if (!solid(x - 1, y)) {
        quad(shape, {vertex(i, j, 0), vertex(i, j, 1), vertex(i, j + 1, 1), vertex(i, j + 1, 0)});
      }
      if (!solid(x + 1, y)) {
        quad(shape, {vertex(i + 1, j, 0), vertex(i + 1, j + 1, 0), vertex(i + 1, j + 1, 1),
                     vertex(i + 1, j, 1)});
      }
    }
  }
  return shape;
}

Shape subdivided(const Shape& shape) {
  Shape result;
  result.positions = shape.positions;
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [it, isNew] = middles.try_emplace(std::minmax(a, b), result.vertexCount());
    if (isNew) {
      const Vec3 p = 0.5 * (at(shape, a) + at(shape, b));
      result.add(p.x, p.y, p.z);
    }
    return it->second;
  };
  for (std::size_t f = 0; f < shape.triangles.size(); f += 3) {
    const Index a = shape.triangles[f], b = shape.triangles[f + 1], c = shape.triangles[f + 2];
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    result.face(a, ab, ca);
    result.face(ab, b, bc);
    result.face(ca, bc, c);
    result.face(ab, bc, ca);
  }
  return result;
}

Shape retriangulated(const Shape& shape, std::uint64_t seed) {
  Shape result = shape;
  Random random(seed);
  std::vector<Index>& t = result.triangles;
  for (int round = 0; round < 3; ++round) {
    std::map<std::pair<Index, Index>, std::size_t> sideOf;  // directed edge → its place in t
    for (std::size_t i = 0; i < t.size(); ++i) {
      sideOf[{t[i], t[i / 3 * 3 + (i + 1) % 3]}] = i;
    }
    std::vector<bool> touched(t.size() / 3, false);
    for (std::size_t i = 0; i < t.size(); ++i) {
      const std::size_t f = i / 3;
      const Index a = t[i], b = t[3 * f + (i + 1) % 3], c = t[3 * f + (i + 2) % 3];
      const auto other = sideOf.find({b, a});
      if (other == sideOf.end() || touched[f] || random() < 0.4) continue;
      const std::size_t j = other->second, g = j / 3;
      const Index d = t[3 * g + (j + 2) % 3];
      if (touched[g] || c == d || sideOf.count({c, d}) || sideOf.count({d, c})) continue;
      const Vec3 A = at(shape, a), B = at(shape, b), C = at(shape, c), D = at(shape, d);
      const Vec3 n1 = cross(B - A, C - A), n2 = cross(A - B, D - B);
      if (norm(cross(n1, n2)) > 1e-12 * norm(n1) * norm(n2) || dot(n1, n2) < 0)
        continue;  // not coplanar
      const double least = 0.05 * norm(n1);
      if (dot(cross(D - C, B - C), n1) < least * norm(n1) ||
          dot(cross(C - D, A - D), n1) < least * norm(n1)) {
        continue;  // not convex
      }
      t[3 * f] = c, t[3 * f + 1] = d, t[3 * f + 2] = b;
      t[3 * g] = d, t[3 * g + 1] = c, t[3 * g + 2] = a;
      touched[f] = touched[g] = true;
      sideOf[{c, d}] = 3 * f;
      sideOf[{d, c}] = 3 * g;
    }
  }
  return result;
}

Shape perturbed(const Shape& shape, double amount, std::uint64_t seed) {
  double mean = 0;
  for (std::size_t i = 0; i < shape.triangles.size(); ++i) {
    const std::size_t j = i / 3 * 3 + (i + 1) % 3;
    mean += norm(at(shape, shape.triangles[i]) - at(shape, shape.triangles[j]));
  }
  mean /= static_cast<double>(shape.triangles.size());
  Shape result = shape;
  Random random(seed);
  for (double& x : result.positions) x += amount * mean * (2 * random() - 1);
  return result;
}

Shape relabelled(const Shape& shape, std::uint64_t seed, std::vector<Index>& newNumber) {
  Random random(seed);
  const Index n = shape.vertexCount();
  newNumber.resize(n);
  for (Index v = 0; v < n; ++v) newNumber[v] = v;
  for (Index v = n; v-- > 1;) std::swap(newNumber[v], newNumber[random.below(v + 1)]);
  Shape result = shape;
  for (Index v = 0; v < n; ++v) {
    for (Index k = 0; k < 3; ++k)
      result.positions[3 * newNumber[v] + k] = shape.positions[3 * v + k];
  }
  std::vector<Index> order(shape.triangles.size() / 3);
  for (Index f = 0; f < order.size(); ++f) order[f] = f;
  for (auto f = static_cast<Index>(order.size()); f-- > 1;)
    std::swap(order[f], order[random.below(f + 1)]);
  for (std::size_t f = 0; f < order.size(); ++f) {
    const Index turn = random.below(3);
    for (Index k = 0; k < 3; ++k) {
      result.triangles[3 * f + k] = newNumber[shape.triangles[3 * order[f] + (k + turn) % 3]];
    }
  }
  return result;
}

Shape moved(const Shape& shape, double scale, double angle, double shift) {
  Shape result = shape;
  const double c = std::cos(angle), s = std::sin(angle);
  for (Index v = 0; v < shape.vertexCount(); ++v) {
    const Vec3 p = at(shape, v);
    const Vec3 q{c * p.x - s * p.y, s * p.x + c * p.y, p.z};  // about z,
    const Vec3 r{q.x, c * q.y - s * q.z, s * q.y + c * q.z};  // then about x
    result.positions[3 * v] = scale * r.x + shift;
    result.positions[3 * v + 1] = scale * r.y - 2 * shift;
    result.positions[3 * v + 2] = scale * r.z + shift / 3;
  }
  return result;
}

Shape shifted(Shape shape, double x, double y, double z) {
  for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
    shape.positions[i] += x;
    shape.positions[i + 1] += y;
    shape.positions[i + 2] += z;
  }
  return shape;
}

Shape together(Shape shape, const Shape& other) {
  const Index first = shape.vertexCount();
  shape.positions.insert(shape.positions.end(), other.positions.begin(), other.positions.end());
  for (const Index v : other.triangles) shape.triangles.push_back(first + v);
  return shape;
}

}  // namespace girth::test
