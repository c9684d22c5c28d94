#include "descriptors/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/vector.h"

namespace girth {

namespace {

constexpr std::size_t kMostInLeaf = 4;
constexpr std::size_t kBins = 16;
/// Below this depth ranges are simply halved, so that the tree stays shallow whatever the surface.
constexpr int kDeepestBySurface = 20;
/// Nodes that wait while a ray goes down: three at each level.
constexpr std::size_t kStack = 3 * (kDeepestBySurface + 16) + 1;

/// Single precision lays boxes and rays out with errors of some 1e-7 of the surface's size; boxes
/// are wider by more than that.
constexpr double kPadding = 4e-6;

double at(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

struct Box {
  Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Vec3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
            -std::numeric_limits<double>::infinity()};

  void add(const Box& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y),
           std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y),
            std::max(high.z, other.high.z)};
  }
  void add(const Vec3& p) { add(Box{p, p}); }
  Vec3 centre() const { return 0.5 * (low + high); }
  /// Half of the surface; 0 where nothing is inside.
  double halfArea() const {
    const Vec3 d = high - low;
    return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

/// Four numbers side by side: one SSE or WebAssembly register.
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

Float4 load(const float* from) {
  Float4 value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}
Float4 all(float x) { return Float4{x, x, x, x}; }
Float4 select(Int4 mask, Float4 a, Float4 b) {
  return (Float4)((mask & (Int4)a) | (~mask & (Int4)b));
}
Float4 smaller(Float4 a, Float4 b) { return select(a < b, a, b); }
Float4 larger(Float4 a, Float4 b) { return select(a > b, a, b); }

}  // namespace

/// Builds the tree over ranges of `order`.
struct TriangleTree::Build {
  struct Item {
    Box box;
    Index face;
  };
  struct Range {
    std::size_t begin, end;
    Box box;
    std::size_t size() const { return end - begin; }
  };

  TriangleTree& tree;
  std::vector<Item> items;
  double padding;

  Range rangeOf(std::size_t begin, std::size_t end) const {
    Range range{begin, end, {}};
    for (std::size_t i = begin; i < end; ++i) range.box.add(items[i].box);
    return range;
  }

  /// Cuts a range in two where the areas of the boxes, times what is in them, add up to least.
  std::array<Range, 2> cut(const Range& range, bool bySurface) {
    std::size_t middle = range.begin + range.size() / 2;
    Box centres;
    for (std::size_t i = range.begin; i < range.end; ++i) centres.add(items[i].box.centre());
    int bestAxis = -1;
    std::size_t bestBin = 0;
    double bestCost = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3 && bySurface; ++axis) {
      const double extent = at(centres.high, axis) - at(centres.low, axis);
      if (!(extent > 0)) continue;
      std::array<Box, kBins> boxes;
      std::array<std::size_t, kBins> counts{};
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const std::size_t bin = binOf(items[i], centres, axis);
        boxes[bin].add(items[i].box);
        ++counts[bin];
      }
      std::array<double, kBins> above{};  // the cost of the bins from one on
      Box box;
      std::size_t count = 0;
      for (std::size_t b = kBins; b-- > 1;) {
        box.add(boxes[b]);
        count += counts[b];
        above[b] = box.halfArea() * static_cast<double>(count);
      }
      box = Box();
      count = 0;
      for (std::size_t b = 1; b < kBins; ++b) {
        box.add(boxes[b - 1]);
        count += counts[b - 1];
        const double cost = box.halfArea() * static_cast<double>(count) + above[b];
        if (count > 0 && count < range.size() && cost < bestCost) {
          bestCost = cost;
          bestAxis = axis;
          bestBin = b;
        }
      }
    }
    if (bestAxis >= 0) {
      const auto first = items.begin() + static_cast<std::ptrdiff_t>(range.begin);
      const auto last = items.begin() + static_cast<std::ptrdiff_t>(range.end);
      const auto split = std::stable_partition(
          first, last, [&](const Item& item) { return binOf(item, centres, bestAxis) < bestBin; });
      middle = static_cast<std::size_t>(split - items.begin());
    }
    return {rangeOf(range.begin, middle), rangeOf(middle, range.end)};
  }

  static std::size_t binOf(const Item& item, const Box& centres, int axis) {
    const double low = at(centres.low, axis), extent = at(centres.high, axis) - low;
    const double place = (at(item.box.centre(), axis) - low) / extent * kBins;
    return std::min(kBins - 1, static_cast<std::size_t>(std::max(0.0, place)));
  }

  /// Makes the node for a range; gives its number.
  Index node(const Range& range, int depth) {
    std::vector<Range> parts{range};
    while (parts.size() < kWidth) {
      const auto largest =
          std::max_element(parts.begin(), parts.end(),
                           [](const Range& a, const Range& b) { return a.size() < b.size(); });
      if (largest->size() <= kMostInLeaf) break;
      const auto [left, right] = cut(*largest, depth < kDeepestBySurface);
      *largest = left;
      parts.push_back(right);
    }
    const auto number = static_cast<Index>(tree.nodes_.size());
    tree.nodes_.emplace_back();
    Node made{};
    for (std::size_t i = 0; i < kWidth; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        made.low[axis][i] = std::numeric_limits<float>::max();
        made.high[axis][i] = -std::numeric_limits<float>::max();
      }
      if (i >= parts.size()) continue;
      for (int axis = 0; axis < 3; ++axis) {
        const double centre = at(tree.centre_, axis);
        made.low[axis][i] = static_cast<float>(at(parts[i].box.low, axis) - centre - padding);
        made.high[axis][i] = static_cast<float>(at(parts[i].box.high, axis) - centre + padding);
      }
      if (parts[i].size() <= kMostInLeaf) {
        made.child[i] = kLeaf | static_cast<Index>(parts[i].begin);
        made.count[i] = static_cast<Index>(parts[i].size());
      } else {
        made.child[i] = node(parts[i], depth + 1);
      }
    }
    tree.nodes_[number] = made;
    return number;
  }
};

TriangleTree::TriangleTree(const SurfaceMesh& mesh) {
  Build build{*this, {}, 0};
  build.items.reserve(mesh.faceCount());
  Box whole;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    Box box;
    for (const Index v : mesh.faceVertices(f)) box.add(mesh.position(v));
    whole.add(box);
    build.items.push_back({box, f});
  }
  centre_ = whole.centre();
  build.padding = kPadding * norm(whole.high - whole.low);
  build.node({0, build.items.size(), whole}, 0);
  triangles_.reserve(build.items.size());
  for (const Build::Item& item : build.items) {
    const auto vertices = mesh.faceVertices(item.face);
    const Vec3& a = mesh.position(vertices[0]);
    triangles_.push_back(
        {a, mesh.position(vertices[1]) - a, mesh.position(vertices[2]) - a, vertices, item.face});
  }
}

std::optional<RayHit> TriangleTree::firstHit(const Vec3& origin, const Vec3& direction,
                                             Index vertex) const {
  Float4 start[3], inverse[3];
  bool backwards[3];
  for (int axis = 0; axis < 3; ++axis) {
    start[axis] = all(static_cast<float>(at(origin, axis) - at(centre_, axis)));
    // A ray along a side never leaves the slab: a huge number does as well as infinity.
    const auto d = static_cast<float>(at(direction, axis));
    backwards[axis] = d < 0;
    inverse[axis] = all(std::fabs(d) > 1e-20f ? 1 / d : (d < 0 ? -1e20f : 1e20f));
  }
  std::optional<RayHit> best;
  double nearest = std::numeric_limits<double>::infinity();

  struct Waiting {
    float enters;
    Index child, count;
  };
  std::array<Waiting, kStack> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0, 0};
  while (depth > 0) {
    const Waiting next = stack[--depth];
    if (next.enters > nearest) continue;
    if ((next.child & kLeaf) != 0) {
      const Index first = next.child & ~kLeaf;
      for (Index i = first; i < first + next.count; ++i) {
        const Triangle& t = triangles_[i];
        // Möller and Trumbore 1997.
        const Vec3 p = cross(direction, t.edgeB);
        const double determinant = dot(t.edgeA, p);
        if (determinant == 0) continue;
        const Vec3 to = origin - t.corner;
        const double u = dot(to, p) / determinant;
        if (!(u >= 0 && u <= 1)) continue;
        const Vec3 q = cross(to, t.edgeA);
        const double v = dot(direction, q) / determinant;
        if (!(v >= 0 && u + v <= 1)) continue;
        const double distance = dot(t.edgeB, q) / determinant;
        if (!(distance > 0) || distance > nearest) continue;
        if (distance == nearest && t.face > best->face) continue;
        if (std::find(t.vertices.begin(), t.vertices.end(), vertex) != t.vertices.end()) continue;
        nearest = distance;
        best = RayHit{distance, t.face, determinant < 0};
      }
      continue;
    }
    const Node& node = nodes_[next.child];
    Float4 enters = all(0), leaves = all(static_cast<float>(nearest));
    for (int axis = 0; axis < 3; ++axis) {
      const Float4 low = load(node.low[axis]), high = load(node.high[axis]);
      const Float4 nearSide = backwards[axis] ? high : low, farSide = backwards[axis] ? low : high;
      enters = larger((nearSide - start[axis]) * inverse[axis], enters);
      leaves = smaller((farSide - start[axis]) * inverse[axis], leaves);
    }
    // The padding covers what rounding moves; a box must not be lost to the last bit here either.
    const Int4 met = enters <= leaves * 1.000001f;
    const std::size_t base = depth;
    for (std::size_t i = 0; i < kWidth; ++i) {
      if (met[i] == 0) continue;
      // The nearest on top.
      std::size_t place = depth++;
      for (; place > base && stack[place - 1].enters < enters[i]; --place) {
        stack[place] = stack[place - 1];
      }
      stack[place] = {enters[i], node.child[i], node.count[i]};
    }
  }
  return best;
}

}  // namespace girth
