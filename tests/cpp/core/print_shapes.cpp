#include "print_shapes.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "mesh/angles.h"

namespace girth::test {

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// A plate with V-shaped grooves, 0.8 deep along x above and 0.9 deep along y below, which cross
/// where there is no vertex: 0.3 is left.
Shape crossingGrooves() {
  Shape s;
  const std::array<double, 5> across{-5, -1, 0, 1, 5}, above{1, 1, 0.2, 1, 1},
      below{-1, -1, -0.1, -1, -1};
  std::array<std::array<Index, 5>, 2> top, bottom;  // at x = ∓5; at y = ∓5
  for (int end = 0; end < 2; ++end) {
    const double at = end == 0 ? -5 : 5;
    for (std::size_t i = 0; i < 5; ++i) top[end][i] = s.add(at, across[i], above[i]);
    for (std::size_t i = 0; i < 5; ++i) bottom[end][i] = s.add(across[i], at, below[i]);
  }
  const auto quad = [&](Index a, Index b, Index c, Index d) {
    s.face(a, b, c);
    s.face(a, c, d);
  };
  for (std::size_t i = 0; i < 4; ++i) {
    quad(top[0][i], top[1][i], top[1][i + 1], top[0][i + 1]);
    quad(bottom[0][i], bottom[1][i], bottom[1][i + 1], bottom[0][i + 1]);
  }
  // A side below five points of the top, above two corners of the bottom.
  const auto side = [&](const std::array<Index, 5>& five, Index first, Index last, bool turned) {
    const auto face = [&](Index a, Index b, Index c) {
      if (turned)
        s.face(a, c, b);
      else
        s.face(a, b, c);
    };
    face(first, five[1], five[0]);
    face(first, five[2], five[1]);
    face(first, last, five[2]);
    face(last, five[3], five[2]);
    face(last, five[4], five[3]);
  };
  side(top[1], bottom[0][4], bottom[1][4], false);
  side(top[0], bottom[0][0], bottom[1][0], true);
  side(bottom[1], top[0][4], top[1][4], false);
  side(bottom[0], top[0][0], top[1][0], true);
  return s;
}

Shape needle(Index around) {
  return revolved({{0, 0}, {20 * std::tan(kPi / 18), 0}, {0, 20}}, around);
}

/// A round cap and a round foot on a cylinder of radius 1.
Shape capsule() {
  std::vector<std::pair<double, double>> profile;
  for (int i = 0; i <= 32; ++i) {
    const double angle = kPi / 2 * (i / 32.0 - 1);
    profile.emplace_back(i == 0 ? 0 : std::cos(angle), std::sin(angle));
  }
  for (int i = 0; i <= 32; ++i) {
    const double angle = kPi / 2 * i / 32.0;
    profile.emplace_back(i == 32 ? 0 : std::cos(angle), 5 + std::sin(angle));
  }
  return revolved(profile, 96);
}

}  // namespace

Shape blocks(const std::vector<double>& xs, const std::vector<double>& ys,
             const std::vector<double>& zs, const std::function<bool(int, int, int)>& isFilled) {
  Shape s;
  std::map<std::array<int, 3>, Index> numbers;
  const auto corner = [&](const std::array<int, 3>& at) {
    const auto [place, isNew] = numbers.try_emplace(at, 0);
    if (isNew) {
      place->second =
          s.add(xs[static_cast<std::size_t>(at[0])], ys[static_cast<std::size_t>(at[1])],
                zs[static_cast<std::size_t>(at[2])]);
    }
    return place->second;
  };
  const std::array<int, 3> cells{static_cast<int>(xs.size()) - 1, static_cast<int>(ys.size()) - 1,
                                 static_cast<int>(zs.size()) - 1};
  const auto filled = [&](const std::array<int, 3>& at) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (at[axis] < 0 || at[axis] >= cells[axis]) return false;
    }
    return isFilled(at[0], at[1], at[2]);
  };
  for (int i = 0; i < cells[0]; ++i) {
    for (int j = 0; j < cells[1]; ++j) {
      for (int k = 0; k < cells[2]; ++k) {
        const std::array<int, 3> cell{i, j, k};
        if (!filled(cell)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const int side : {0, 1}) {
            std::array<int, 3> beside = cell;
            beside[axis] += side == 0 ? -1 : 1;
            if (filled(beside)) continue;
            std::array<int, 3> a = cell;
            a[axis] += side;
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            std::array<int, 3> b = a, c = a, d = a;
            ++b[u], ++c[u], ++c[v], ++d[v];
            if (side == 0) std::swap(b, d);
            s.face(corner(a), corner(b), corner(c));
            s.face(corner(a), corner(c), corner(d));
          }
        }
      }
    }
  }
  return s;
}

Shape revolved(const std::vector<std::pair<double, double>>& profile, Index around) {
  Shape s;
  const bool closed = profile.front().first > 0;
  std::vector<std::vector<Index>> rings;
  for (const auto& [radius, height] : profile) {
    std::vector<Index> ring;
    for (Index i = 0; i < around; ++i) {
      if (radius > 0 || i == 0) {
        const double angle = 2 * kPi * i / around;
        ring.push_back(s.add(radius * std::cos(angle), radius * std::sin(angle), height));
      } else {
        ring.push_back(ring[0]);
      }
    }
    rings.push_back(std::move(ring));
  }
  const std::size_t bands = closed ? rings.size() : rings.size() - 1;
  for (std::size_t r = 0; r < bands; ++r) {
    const std::vector<Index>&low = rings[r], &high = rings[(r + 1) % rings.size()];
    for (Index i = 0; i < around; ++i) {
      const Index k = (i + 1) % around;
      if (low[i] != low[k]) s.face(low[i], low[k], high[k]);
      if (high[i] != high[k]) s.face(low[i], high[k], high[i]);
    }
  }
  return s;
}

Shape turnedOver(Shape shape) {
  for (std::size_t i = 0; i < shape.triangles.size(); i += 3) {
    std::swap(shape.triangles[i], shape.triangles[i + 1]);
  }
  return shape;
}

std::vector<PrintShape> printShapes() {
  const auto scaled = [](Shape shape, double scale) {
    for (double& x : shape.positions) x *= scale;
    return shape;
  };
  const double facet = kPi / 128;
  const double blade = std::tan(0.1);  // tangent of half its angle
  const std::vector<double> five{0, 4, 5, 6, 10};
  std::vector<PrintShape> shapes{
      {"plate", box(20, 20, 0.7, 1, 1, 1), 0.7, kNone},
      {"plate, many triangles, turned", moved(box(20, 20, 0.7, 20, 20, 1), 1, 0.7, 5), 0.7, kNone},
      {"disc", prism(regularPolygon(64, 0.5), 0.7, 1), 0.7, kNone},
      {"cube", box(10, 10, 10, 1, 1, 1), 10, kNone},
      {"cube, many triangles", box(10, 10, 10, 7, 7, 7), 10, kNone},
      {"brick", box(3, 2, 0.5, 1, 1, 1), 0.5, kNone},
      {"square bar", box(20, 1, 1, 1, 1, 1), 1, kNone},
      {"flat bar", box(20, 4, 1, 1, 1, 1), 1, kNone},
      {"round bar", revolved({{0, 0}, {1, 0}, {1, 20}, {0, 20}}, 128), 2 * std::cos(facet), kNone},
      {"hexagonal bar", prism(regularPolygon(6, 5), 20, 1), 5 * std::sqrt(3.0), kNone, 1e-9,
       10 / std::sqrt(3.0)},
      {"triangular bar", prism(regularPolygon(3, 5), 20, 1), 0, kNone},
      {"tetrahedron", tetrahedron(), 0, kNone},
      {"sphere", icosphere(4), 2, kNone, 2e-3},
      {"small sphere, turned", moved(icosphere(4), 0.01, 0.7, 5), 0.02, kNone, 2e-3},
      {"hollow sphere", together(icosphere(4), turnedOver(scaled(icosphere(4), 0.8))), 0.2, kNone,
       5e-3},
      {"tube", revolved({{1, 0}, {1, 10}, {0.8, 10}, {0.8, 0}}, 128), 0.2 * std::cos(facet), kNone},
      {"washer", revolved({{5, 0}, {5, 0.3}, {2, 0.3}, {2, 0}}, 64), 0.3, kNone},
      {"torus", torus(3, 0.5, 160, 80), 1, kNone, 2e-3},
      {"capsule", capsule(), 2, kNone, 2e-3},
      {"cup", revolved({{0, 0}, {3, 0}, {3, 8}, {2.6, 8}, {2.6, 0.5}, {0, 0.5}}, 128),
       0.4 * std::cos(facet), kNone},
      {"wedge", prism({0, 0, 10, 0, 10, 10 * std::tan(0.2)}, 10, 1), 0, kNone},
      {"blade with a blunt edge",
       prism({0, -0.15, 10, -0.15 - 10 * blade, 10, 0.15 + 10 * blade, 0, 0.15}, 10, 1),
       0.3 / std::cos(0.1), kNone},
      {"needle", needle(24), 0, kNone},
      {"pocket from below",
       blocks(five, five, {0, 2.6, 3},
              [](int i, int j, int k) { return k == 1 || i == 0 || i == 3 || j == 0 || j == 3; }),
       0.4, 2},
      {"grooves that cross", crossingGrooves(), 0.3, kNone},
      {"fin on a block",
       blocks({0, 5, 5.2, 10}, {0, 10}, {0, 5, 5.3},
              [](int i, int, int k) { return k == 0 || i == 1; }),
       0.2, kNone},
      {"low boss on a block",
       blocks(five, five, {0, 5, 5.3},
              [](int i, int j, int k) { return k == 0 || (i >= 1 && i <= 2 && j >= 1 && j <= 2); }),
       2, kNone},
      {"step",
       blocks({0, 5, 10}, {0, 10}, {0, 1, 4}, [](int i, int, int k) { return k == 0 || i == 0; }),
       1, kNone},
      {"slot",
       blocks({0, 4, 4.3, 10}, {0, 10}, {0, 3, 8},
              [](int i, int, int k) { return k == 0 || i != 1; }),
       3, 0.3},
      {"comb",
       blocks({0, 1, 1.5, 2.5, 3.0, 4.0}, {0, 10}, {0, 2, 6},
              [](int i, int, int k) { return k == 0 || i % 2 == 0; }),
       1, 0.5},
      {"two cubes with a gap",
       together(box(10, 10, 10, 1, 1, 1), shifted(box(10, 10, 10, 1, 1, 1), 10.2, 3, 2)), 10, 0.2},
      {"two cubes that touch",
       together(box(10, 10, 10, 1, 1, 1), shifted(box(10, 10, 10, 1, 1, 1), 1, 2, 10)), 10, kNone},
      {"pin in a hole",
       together(revolved({{1.2, 0}, {4, 0}, {4, 5}, {1.2, 5}}, 128),
                shifted(revolved({{0, 0}, {1, 0}, {1, 7}, {0, 7}}, 128), 0, 0, -1)),
       2 * std::cos(facet), 0.2 * std::cos(facet)},
      {"box with a cavity",
       blocks({0, 0.5, 9.5, 10}, {0, 0.6, 9, 10}, {0, 0.4, 9, 10},
              [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; }),
       0.4, 8.4},
  };
  return shapes;
}

}  // namespace girth::test
