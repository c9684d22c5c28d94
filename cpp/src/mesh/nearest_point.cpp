#include "mesh/nearest_point.h"

#include <algorithm>
#include <utility>

namespace girth {

TrianglePoint nearestInTriangle(const Vec3& p, const std::array<Vec3, 3>& triangle) {
  // Not bound by one declaration: a lambda may not use that in C++20 as Clang 14 has it.
  const Vec3 &a = triangle[0], &b = triangle[1], &c = triangle[2];
  const auto at = [&](double u, double v, double w) {
    return TrianglePoint{{u, v, w}, u * a + v * b + w * c};
  };
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return at(1, 0, 0);
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return at(0, 1, 0);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 - d3 > 0 ? d1 / (d1 - d3) : 0;
    return at(1 - v, v, 0);
  }
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return at(0, 0, 1);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 - d6 > 0 ? d2 / (d2 - d6) : 0;
    return at(1 - w, 0, w);
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double whole = (d4 - d3) + (d5 - d6);
    const double w = whole > 0 ? (d4 - d3) / whole : 0;
    return at(0, 1 - w, w);
  }
  const double sum = va + vb + vc;
  const double v = vb / sum, w = vc / sum;
  return at(1 - v - w, v, w);
}

double NearestSearch::Box::squaredDistance(const Vec3& p) const {
  const auto outside = [](double x, double from, double to) {
    return x < from ? from - x : x > to ? x - to : 0;
  };
  const Vec3 d{outside(p.x, low.x, high.x), outside(p.y, low.y, high.y),
               outside(p.z, low.z, high.z)};
  return dot(d, d);
}

NearestSearch::NearestSearch(std::vector<std::array<Vec3, 3>> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size()) {
  if (triangles_.empty()) return;
  for (Index t = 0; t < order_.size(); ++t) order_[t] = t;
  struct Range {
    Index node, begin, end;
  };
  nodes_.emplace_back();
  std::vector<Range> todo{{0, 0, static_cast<Index>(order_.size())}};
  while (!todo.empty()) {
    const Range part = todo.back();
    todo.pop_back();
    const Vec3& corner = triangles_[order_[part.begin]][0];
    Box box{corner, corner};
    const auto middle = [&](Index t) {
      const auto& [a, b, c] = triangles_[t];
      return a + b + c;
    };
    Vec3 low = middle(order_[part.begin]), high = low;
    const auto widen = [](Vec3& from, Vec3& to, const Vec3& p) {
      from = {std::min(from.x, p.x), std::min(from.y, p.y), std::min(from.z, p.z)};
      to = {std::max(to.x, p.x), std::max(to.y, p.y), std::max(to.z, p.z)};
    };
    for (Index i = part.begin; i < part.end; ++i) {
      for (const Vec3& p : triangles_[order_[i]]) widen(box.low, box.high, p);
      widen(low, high, middle(order_[i]));
    }
    nodes_[part.node].box = box;
    if (part.end - part.begin <= kInBox) {
      nodes_[part.node].first = part.begin;
      nodes_[part.node].count = part.end - part.begin;
      continue;
    }
    // In halves, across the longest side of the box of their middles; so the depth is bounded.
    const Vec3 size = high - low;
    const auto key = [&](Index t) {
      const Vec3 m = middle(t);
      return size.x >= size.y && size.x >= size.z ? m.x : size.y >= size.z ? m.y : m.z;
    };
    const Index half = (part.begin + part.end) / 2;
    std::nth_element(order_.begin() + part.begin, order_.begin() + half, order_.begin() + part.end,
                     [&](Index s, Index t) {
                       const double a = key(s), b = key(t);
                       return a != b ? a < b : s < t;
                     });
    const auto child = static_cast<Index>(nodes_.size());
    nodes_[part.node].first = child;
    nodes_.resize(nodes_.size() + 2);
    todo.push_back({child, part.begin, half});
    todo.push_back({child + 1, half, part.end});
  }
}

}  // namespace girth
