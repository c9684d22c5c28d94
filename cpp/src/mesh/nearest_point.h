// The nearest of many triangles or segments to a point.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "mesh/vector.h"

namespace girth {

/// The point of a triangle nearest to another, by its barycentric coordinates. Triangles may be
/// degenerate (Ericson 2005, section 5.1.5).
struct TrianglePoint {
  std::array<double, 3> weights;
  Vec3 position;
};
TrianglePoint nearestInTriangle(const Vec3& p, const std::array<Vec3, 3>& triangle);

/// A tree of boxes round triangles. A segment is a triangle whose last two corners are one.
class NearestSearch {
 public:
  NearestSearch() = default;
  explicit NearestSearch(std::vector<std::array<Vec3, 3>> triangles);

  struct Found {
    Index triangle{kNoIndex};
    std::array<double, 3> weights{1, 0, 0};
    Vec3 position;
    double distance{std::numeric_limits<double>::infinity()};
  };

  /// The nearest point of the triangles that `accepts` says yes to. `hint` is looked at first.
  template <class Accepts>
  Found nearest(const Vec3& p, Accepts&& accepts, Index hint = kNoIndex) const {
    Found found;
    double bound = std::numeric_limits<double>::infinity();  // squared
    const auto look = [&](Index t) {
      const TrianglePoint point = nearestInTriangle(p, triangles_[t]);
      const Vec3 d = point.position - p;
      const double squared = dot(d, d);
      if (!(squared < bound)) return;
      bound = squared;
      found = {t, point.weights, point.position, 0};
    };
    if (triangles_.empty()) return found;
    if (hint != kNoIndex && accepts(hint)) look(hint);
    std::array<Index, 64> stack;
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (node.box.squaredDistance(p) >= bound) continue;
      if (node.count > 0) {
        for (Index i = node.first; i < node.first + node.count; ++i) {
          if (accepts(order_[i])) look(order_[i]);
        }
        continue;
      }
      // The nearer child last, and so first from the stack.
      const Index left = node.first, right = node.first + 1;
      const bool leftFirst =
          nodes_[left].box.squaredDistance(p) <= nodes_[right].box.squaredDistance(p);
      stack[depth++] = leftFirst ? right : left;
      stack[depth++] = leftFirst ? left : right;
    }
    found.distance = std::sqrt(bound);
    return found;
  }
  Found nearest(const Vec3& p) const {
    return nearest(p, [](Index) { return true; });
  }

  const std::array<Vec3, 3>& triangle(Index t) const { return triangles_[t]; }
  bool empty() const { return triangles_.empty(); }

 private:
  struct Box {
    Vec3 low, high;
    double squaredDistance(const Vec3& p) const;
  };
  struct Node {
    Box box;
    Index first{0};  ///< of its triangles in `order_`, or its left child; the right one is next
    Index count{0};  ///< of its triangles; 0: an inner node
  };
  std::vector<std::array<Vec3, 3>> triangles_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

}  // namespace girth
