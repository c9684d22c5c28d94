#include "fingers.h"

#include <array>
#include <cmath>
#include <map>

#include "mesh/vector.h"

namespace girth::test {

namespace {

/// From the middle of one finger to that of the next; the height of the box.
constexpr int kApart = 2, kBoxHeight = 1;

/// A section of a finger: the axis goes through `centre`; `across` is the direction in which the
/// finger bends, longer where the section is oblique.
struct Section {
  Vec3 centre, across;
};

/// Sections above the base, at most `spacing` apart.
std::vector<Section> sectionsOf(const Finger& finger, double x, double spacing) {
  const double straight = finger.length / static_cast<double>(finger.bends.size() + 1);
  const auto count = static_cast<Index>(std::ceil(straight / spacing - 1e-9));
  Vec3 from{x, 0.5, kBoxHeight};
  double angle = 0;
  std::vector<Section> sections;
  double before = 0;  // half of the bend below
  for (std::size_t part = 0; part <= finger.bends.size(); ++part) {
    const double after = part < finger.bends.size() ? finger.bends[part] / 2 : 0;
    const Vec3 along{std::sin(angle), 0, std::cos(angle)};
    const Vec3 square{std::cos(angle), 0, -std::sin(angle)};
    for (Index i = 1; i <= count; ++i) {
      const double share = static_cast<double>(i) / count;
      // Oblique as the joint below, then as the one above: never in between, so that sections do
      // not cut each other, the obliqueness changes evenly.
      const double slant = (1 - share) * std::tan(-before) + share * std::tan(after);
      sections.push_back({from + (share * straight) * along, square + (-slant) * along});
    }
    from = from + straight * along;
    angle += 2 * after;
    before = after;
  }
  return sections;
}

}  // namespace

Shape fingersOnBox(const std::vector<Finger>& fingers, Index cells) {
  Shape shape;
  const int n = static_cast<int>(cells);
  const int width = (kApart * static_cast<int>(fingers.size()) + 1) * n, height = kBoxHeight * n;
  std::map<std::array<int, 3>, Index> lattice;
  const auto at = [&](int i, int j, int k) {
    const auto [entry, isNew] = lattice.try_emplace({i, j, k}, 0);
    if (isNew) {
      entry->second = shape.add(static_cast<double>(i) / n, static_cast<double>(j) / n,
                                static_cast<double>(k) / n);
    }
    return entry->second;
  };
  const auto quad = [&](Index a, Index b, Index c, Index d) {
    shape.face(a, b, c);
    shape.face(a, c, d);
  };
  // The box is three widths deep: the fingers stand on the middle one.
  const int front = -n, back = 2 * n;
  for (int i = 0; i < width; ++i) {
    for (int j = front; j < back; ++j) {
      quad(at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0));
      if (i / n % kApart == 1 && j >= 0 && j < n) continue;  // a finger
      quad(at(i, j, height), at(i + 1, j, height), at(i + 1, j + 1, height), at(i, j + 1, height));
    }
    for (int k = 0; k < height; ++k) {
      quad(at(i, front, k), at(i + 1, front, k), at(i + 1, front, k + 1), at(i, front, k + 1));
      quad(at(i, back, k), at(i, back, k + 1), at(i + 1, back, k + 1), at(i + 1, back, k));
    }
  }
  for (int j = front; j < back; ++j) {
    for (int k = 0; k < height; ++k) {
      quad(at(0, j, k), at(0, j, k + 1), at(0, j + 1, k + 1), at(0, j + 1, k));
      quad(at(width, j, k), at(width, j + 1, k), at(width, j + 1, k + 1), at(width, j, k + 1));
    }
  }
  for (std::size_t f = 0; f < fingers.size(); ++f) {
    const int left = (1 + kApart * static_cast<int>(f)) * n;
    // Round the rim, counter-clockwise seen from above.
    std::vector<std::array<int, 2>> rim;
    for (int i = 0; i < n; ++i) rim.push_back({i, 0});
    for (int i = 0; i < n; ++i) rim.push_back({n, i});
    for (int i = 0; i < n; ++i) rim.push_back({n - i, n});
    for (int i = 0; i < n; ++i) rim.push_back({0, n - i});
    std::vector<Index> below;
    for (const auto& [i, j] : rim) below.push_back(at(left + i, j, height));
    const auto sections =
        sectionsOf(fingers[f], static_cast<double>(left) / n + 0.5, 1.0 / static_cast<double>(n));
    const auto place = [&](const Section& section, int i, int j) {
      const Vec3 p = section.centre + (static_cast<double>(i) / n - 0.5) * section.across;
      return shape.add(p.x, p.y + static_cast<double>(j) / n - 0.5, p.z);
    };
    for (const Section& section : sections) {
      std::vector<Index> above;
      for (const auto& [i, j] : rim) above.push_back(place(section, i, j));
      for (std::size_t c = 0; c < rim.size(); ++c) {
        const std::size_t d = (c + 1) % rim.size();
        quad(below[c], below[d], above[d], above[c]);
      }
      below = std::move(above);
    }
    std::map<std::array<int, 2>, Index> cap;
    for (std::size_t c = 0; c < rim.size(); ++c) cap[rim[c]] = below[c];
    for (int i = 1; i < n; ++i) {
      for (int j = 1; j < n; ++j) cap[{i, j}] = place(sections.back(), i, j);
    }
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        quad(cap[{i, j}], cap[{i + 1, j}], cap[{i + 1, j + 1}], cap[{i, j + 1}]);
      }
    }
  }
  return shape;
}

std::vector<Vertex> baseCorners(const SurfaceMesh& mesh, std::size_t finger) {
  const double left = 1 + kApart * static_cast<double>(finger);
  std::vector<Vertex> corners;
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    for (const double x : {left, left + 1}) {
      for (const double y : {0.0, 1.0}) {
        if (norm(p - Vec3{x, y, kBoxHeight}) < 1e-9) corners.push_back(v);
      }
    }
  }
  return corners;
}

}  // namespace girth::test
