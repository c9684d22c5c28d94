#include "random_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace girth::test {

namespace {

std::array<double, 3> placeOf(const Shape& shape, Index v) {
  return {shape.positions[3 * v], shape.positions[3 * v + 1], shape.positions[3 * v + 2]};
}

/// One number each for what the tests want to repeat; digits enough to be recognised.
std::string text(double x) { return std::to_string(x).substr(0, 6); }

/// A closed grid with random heights: above, below and round the handles of a plate.
Shape terrain(Random& random, std::string& history) {
  const std::array<std::pair<Index, Index>, 5> holes = {{{0, 0}, {1, 1}, {1, 2}, {1, 3}, {2, 2}}};
  const Index genus = random.below(5);
  Shape shape = plate(holes[genus].first, holes[genus].second);
  if (genus < 2 || random() < 0.2) shape = subdivided(shape);
  if (genus == 0) shape = subdivided(shape);
  const double height = 2 * random();
  for (Index v = 0; v < shape.vertexCount(); ++v) {
    double& z = shape.positions[3 * v + 2];
    z *= 1 + height * random();
  }
  history = "plate of genus " + std::to_string(genus) + " with heights to " + text(height);
  return shape;
}

Shape blob(Random& random, std::string& history) {
  Shape shape = random() < 0.5 ? octasphere(2) : icosphere(1);
  const double amount = random();
  for (Index v = 0; v < shape.vertexCount(); ++v) {
    const double radius = 1 - amount * random();
    for (Index k = 0; k < 3; ++k) shape.positions[3 * v + k] *= radius;
  }
  history = "blob with radii from " + text(1 - amount);
  return shape;
}

Shape base(Random& random, std::string& history) {
  switch (random.below(6)) {
    case 0:
    case 1:
      return terrain(random, history);
    case 2:
      return blob(random, history);
    case 3: {
      const Index around = 3 + random.below(12), across = 3 + random.below(7);
      const double r = 0.1 + 0.8 * random();
      history =
          "torus " + std::to_string(around) + " by " + std::to_string(across) + ", r " + text(r);
      return torus(1, r, around, across);
    }
    case 4: {
      const Index sides = 3 + random.below(8), parts = 1 + random.below(2);
      const Index rings = 1 + random.below(120 / (sides * parts));
      const double height = 0.2 + 6 * random();
      history = "prism of " + std::to_string(sides) + " by " + std::to_string(parts) +
                " sides, height " + text(height) + " in " + std::to_string(rings);
      if (random() < 0.3) {
        history = "pyramid, " + history;
        return pyramid(sides, 0.5 + 2.3 * random(), rings);
      }
      return prism(regularPolygon(sides, 1, parts), height, rings);
    }
    default: {
      const Index x = 1 + random.below(3), y = 1 + random.below(3), z = 1 + random.below(8);
      const double b = random() < 0.5 ? 1 : 0.1 + random(),
                   c = random() < 0.5 ? z : 4 * random() + 0.1;
      history = "box 1 by " + text(b) + " by " + text(c);
      return box(1, b, c, x, y, z);
    }
  }
}

/// A new vertex in the face of a side, at share `s` of the side and then, where `r` is not 0, at
/// share `r` of the way to the opposite corner.
void divide(Shape& shape, Index side, double s, double r) {
  std::vector<Index>& t = shape.triangles;
  const Index f = side / 3;
  const Index a = t[side], b = t[3 * f + (side + 1) % 3], c = t[3 * f + (side + 2) % 3];
  const auto pa = placeOf(shape, a), pb = placeOf(shape, b), pc = placeOf(shape, c);
  std::array<double, 3> p{};
  for (int k = 0; k < 3; ++k) {
    p[k] = pa[k] + s * (pb[k] - pa[k]);
    p[k] += r * (pc[k] - p[k]);
  }
  const Index m = shape.add(p[0], p[1], p[2]);
  t[3 * f] = m, t[3 * f + 1] = b, t[3 * f + 2] = c;
  shape.face(m, c, a);
  if (r > 0) {
    shape.face(m, a, b);
    return;
  }
  for (std::size_t j = 0; j < t.size(); ++j) {
    const std::size_t g = j / 3;
    if (t[j] != b || t[3 * g + (j + 1) % 3] != a) continue;
    const Index d = t[3 * g + (j + 2) % 3];
    t[3 * g] = m, t[3 * g + 1] = a, t[3 * g + 2] = d;
    shape.face(m, d, b);
    return;
  }
}

}  // namespace

bool isSurface(const Shape& shape, double narrowest) {
  const auto mesh = SurfaceMesh::fromArrays(shape.positions, shape.triangles, OpenEdges::Boundary);
  if (!mesh) return false;
  for (const Halfedge h : mesh.value().halfedges()) {
    if (mesh.value().cornerAngle(h) < narrowest) return false;
  }
  return true;
}

RandomMesh randomMesh(std::uint64_t seed, double narrowest) {
  Random random(seed);
  for (int i = 0; i < 3; ++i) random();  // seeds near each other begin alike
  RandomMesh mesh;
  mesh.shape = base(random, mesh.history);
  const auto become = [&](Shape shape, const std::string& how) {
    if (!isSurface(shape, narrowest)) return;
    mesh.shape = std::move(shape);
    mesh.history += ", " + how;
  };
  const auto newSeed = [&] { return static_cast<std::uint64_t>(random.below(1 << 30)); };
  if (random() < 0.5) become(retriangulated(mesh.shape, newSeed()), "retriangulated");
  if (random() < 0.2) {
    const double stretch = std::exp(3.5 * random());
    Shape shape = mesh.shape;
    for (Index v = 0; v < shape.vertexCount(); ++v) shape.positions[3 * v] *= stretch;
    become(shape, "stretched by " + text(stretch));
  }
  constexpr std::array<double, 6> kNoise = {0, 0, 0.01, 0.15, 0.5, 0.5};
  const double noise = kNoise[random.below(kNoise.size())];
  if (noise > 0) become(perturbed(mesh.shape, noise, newSeed()), "noise " + text(noise));
  if (random() < 0.3) {
    const Index cuts = 1 + random.below(4);
    mesh.shape = withHoles(mesh.shape, cuts, newSeed());
    mesh.closed = false;
    mesh.history += ", with holes from " + std::to_string(cuts) + " cuts";
  }
  if (random() < 0.4) {
    const double closest = std::pow(10, -4 * random());
    become(divided(mesh.shape, 0.3 * closest, 1 + random.below(30), newSeed()),
           "divided from " + text(closest));
    if (random() < 0.5) become(retriangulated(mesh.shape, newSeed()), "retriangulated");
  }
  if (mesh.shape.vertexCount() < 60 && random() < 0.4) become(subdivided(mesh.shape), "subdivided");
  return mesh;
}

Shape divided(const Shape& shape, double closest, Index times, std::uint64_t seed) {
  Shape result = shape;
  Random random(seed);
  const auto share = [&] {
    const double s = closest * std::pow(1 / (2 * closest), random());  // as often near an end
    return random() < 0.5 ? s : 1 - s;
  };
  for (Index i = 0; i < times; ++i) {
    const Index side = random.below(static_cast<Index>(result.triangles.size()));
    const double s = share();
    divide(result, side, s, random() < 0.5 ? 0 : share());  // on the side, or in the face
  }
  return result;
}

Shape withVertexAt(const Shape& shape, const SurfacePoint& point) {
  Shape result = shape;
  const auto& w = point.weights;
  if (point.kind == SurfacePoint::Kind::OnEdge) {
    divide(result, point.element, w[1], 0);
  } else {
    divide(result, 3 * point.element, w[1] / (w[0] + w[1]), w[2]);
  }
  return result;
}

Shape withoutLoneVertices(const Shape& shape) {
  Shape result;
  std::vector<Index> newNumber(shape.vertexCount(), kNoIndex);
  for (const Index v : shape.triangles) {
    if (newNumber[v] == kNoIndex) {
      const auto p = placeOf(shape, v);
      newNumber[v] = result.add(p[0], p[1], p[2]);
    }
    result.triangles.push_back(newNumber[v]);
  }
  return result;
}

Shape withHoles(const Shape& shape, Index cuts, std::uint64_t seed) {
  Random random(seed);
  Shape result = shape;
  for (Index i = 0; i < cuts; ++i) {
    const bool wholeStar = random() < 0.5;
    const Index corner = random.below(static_cast<Index>(result.triangles.size()));
    const Index centre = result.triangles[corner];
    Shape rest;
    rest.positions = result.positions;
    for (std::size_t f = 0; f < result.triangles.size(); f += 3) {
      const Index u = result.triangles[f], v = result.triangles[f + 1], w = result.triangles[f + 2];
      const bool cut = wholeStar ? u == centre || v == centre || w == centre : f / 3 == corner / 3;
      if (!cut) rest.face(u, v, w);
    }
    rest = withoutLoneVertices(rest);
    if (isSurface(rest, 0) && rest.mesh(OpenEdges::Boundary).componentCount() == 1) result = rest;
  }
  return result;
}

Shape reflected(const Shape& shape, std::uint64_t seed) {
  Random random(seed);
  // A plane through three random points of sides passes through the midst of things.
  std::array<double, 3> normal{}, through{};
  double length = 0;
  for (double& x : normal) {
    x = 2 * random() - 1;
    length += x * x;
  }
  for (double& x : normal) x /= std::sqrt(length);
  const auto a = placeOf(shape, random.below(shape.vertexCount()));
  const auto b = placeOf(shape, random.below(shape.vertexCount()));
  for (int k = 0; k < 3; ++k) through[k] = 0.4 * a[k] + 0.6 * b[k];
  const auto above = [&](const std::array<double, 3>& p) {
    double height = 0;
    for (int k = 0; k < 3; ++k) height += normal[k] * (p[k] - through[k]);
    return height;
  };
  Shape result;
  result.positions = shape.positions;
  std::vector<double> height(shape.vertexCount());
  for (Index v = 0; v < shape.vertexCount(); ++v) {
    height[v] = above(placeOf(shape, v));
    if (height[v] <= 0) continue;
    for (Index k = 0; k < 3; ++k) result.positions[3 * v + k] -= 2 * height[v] * normal[k];
  }
  std::map<std::pair<Index, Index>, Index> cuts;
  const auto cut = [&](Index u, Index v) {
    const auto [it, isNew] = cuts.try_emplace(std::minmax(u, v), result.vertexCount());
    if (isNew) {
      const auto pu = placeOf(shape, it->first.first), pv = placeOf(shape, it->first.second);
      const double hu = height[it->first.first], hv = height[it->first.second];
      const double s = hu / (hu - hv);
      result.add(pu[0] + s * (pv[0] - pu[0]), pu[1] + s * (pv[1] - pu[1]),
                 pu[2] + s * (pv[2] - pu[2]));
    }
    return it->second;
  };
  for (std::size_t f = 0; f < shape.triangles.size(); f += 3) {
    // Turned so that the corner alone on its side of the plane comes first.
    std::array<Index, 3> v = {shape.triangles[f], shape.triangles[f + 1], shape.triangles[f + 2]};
    const auto isAbove = [&](Index corner) { return height[corner] > 0; };
    for (int turn = 0; turn < 2 && isAbove(v[1]) != isAbove(v[2]); ++turn) {
      v = {v[1], v[2], v[0]};
    }
    if (isAbove(v[0]) == isAbove(v[1])) {
      result.face(v[0], v[1], v[2]);
      continue;
    }
    const Index first = cut(v[0], v[1]), second = cut(v[0], v[2]);
    result.face(v[0], first, second);
    result.face(first, v[1], v[2]);
    result.face(first, v[2], second);
  }
  return result;
}

}  // namespace girth::test
