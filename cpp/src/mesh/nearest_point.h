// The nearest of many triangles or segments to a point, and other searches among triangles.
#pragma once

#include <algorithm>
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

  /// The nearest point of the triangles for which `accepts` is true. `hint` is looked at first.
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

  /// A box with sides along the axes.
  struct Box {
    Vec3 low, high;
    double squaredDistance(const Vec3& p) const;
  };

  /// Calls `look(t)` for triangles in boxes that count. `urgency(node, box)` is asked about a box
  /// when it is found, and again when its turn comes; infinite: it does not count. The one of two
  /// boxes with the smaller urgency comes first.
  template <class Urgency, class Look>
  void search(Urgency&& urgency, Look&& look) const {
    constexpr double never = std::numeric_limits<double>::infinity();
    std::array<Index, 64> stack;
    std::size_t depth = 0;
    if (!triangles_.empty()) stack[depth++] = 0;
    while (depth > 0) {
      const Index number = stack[--depth];
      const Node& node = nodes_[number];
      if (urgency(number, node.box) == never) continue;
      if (node.count > 0) {
        // By their numbers: in which order the box has them differs between standard libraries.
        std::array<Index, kInBox> inBox{};
        std::copy_n(order_.begin() + node.first, node.count, inBox.begin());
        std::sort(inBox.begin(), inBox.begin() + node.count);
        for (Index i = 0; i < node.count; ++i) look(inBox[i]);
        continue;
      }
      const Index left = node.first, right = node.first + 1;
      const double atLeft = urgency(left, nodes_[left].box),
                   atRight = urgency(right, nodes_[right].box);
      // The first one last, and so first from the stack.
      const bool leftFirst = atLeft <= atRight;
      if (std::max(atLeft, atRight) < never) stack[depth++] = leftFirst ? right : left;
      if (std::min(atLeft, atRight) < never) stack[depth++] = leftFirst ? left : right;
    }
  }

  /// Something for every box, by its number: `of(t)` of its triangles, put together by `add`.
  template <class Value, class Of, class Add>
  std::vector<Value> overBoxes(Of&& of, Add&& add) const {
    std::vector<Value> values(nodes_.size());
    for (std::size_t n = nodes_.size(); n-- > 0;) {  // children come after their parents
      const Node& node = nodes_[n];
      if (node.count == 0) {
        values[n] = values[node.first];
        add(values[n], values[node.first + 1]);
        continue;
      }
      values[n] = of(order_[node.first]);
      for (Index i = 1; i < node.count; ++i) add(values[n], of(order_[node.first + i]));
    }
    return values;
  }

  const std::array<Vec3, 3>& triangle(Index t) const { return triangles_[t]; }
  bool empty() const { return triangles_.empty(); }

 private:
  /// Triangles of a box that has no boxes in it, at most.
  static constexpr Index kInBox = 4;
  struct Node {
    Box box;
    Index first{
        0};  ///< first of its triangles in `order_`, or its left child; the right one is next
    Index count{0};  ///< number of its triangles; 0: an inner node
  };
  std::vector<std::array<Vec3, 3>> triangles_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

}  // namespace girth
