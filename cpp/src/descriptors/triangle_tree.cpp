#include "descriptors/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/vector.h"

namespace girth {

namespace {

constexpr std::size_t kBins = 16;
/// Below this depth ranges are simply halved, so that the tree stays shallow whatever the surface.
constexpr std::size_t kDeepestBySurface = kDeepest - 16;
/// Single precision lays boxes and rays out with errors of some 1e-7 of the surface's size, which
/// is about 1 there; boxes are wider by more than that.
constexpr double kPadding = 4e-6;
constexpr float kFarAway = std::numeric_limits<float>::max();

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
  const SurfaceMesh& mesh;
  std::vector<Item> items;

  Range rangeOf(std::size_t begin, std::size_t end) const {
    Range range{begin, end, {}};
    for (std::size_t i = begin; i < end; ++i) range.box.add(items[i].box);
    return range;
  }

  /// Cuts a range in two where the areas of the boxes, times the blocks in them, add up to least.
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
        above[b] = box.halfArea() * blocksFor(count);
      }
      box = Box();
      count = 0;
      for (std::size_t b = 1; b < kBins; ++b) {
        box.add(boxes[b - 1]);
        count += counts[b - 1];
        const double cost = box.halfArea() * blocksFor(count) + above[b];
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

  static double blocksFor(std::size_t triangles) {
    const std::size_t blocks = (triangles + kBlock - 1) / kBlock;
    return static_cast<double>(blocks);
  }

  /// Makes the node for a range; gives its number.
  Index node(const Range& range, std::size_t depth) {
    std::vector<Range> parts{range};
    while (parts.size() < kBranches) {
      const auto largest =
          std::max_element(parts.begin(), parts.end(),
                           [](const Range& a, const Range& b) { return a.size() < b.size(); });
      if (largest->size() <= kBlock) break;
      const auto [left, right] = cut(*largest, depth < kDeepestBySurface);
      *largest = left;
      parts.push_back(right);
    }
    const auto number = static_cast<Index>(tree.nodes_.size());
    tree.nodes_.emplace_back();
    TreeNode made{};
    for (std::size_t i = 0; i < kBranches; ++i) {
      const bool used = i < parts.size();
      for (int axis = 0; axis < 3; ++axis) {
        made.sides[axis][i] =
            used ? inBoxes(at(parts[i].box.low, axis), axis, -kPadding) : kFarAway;
        made.sides[axis + 3][i] =
            used ? inBoxes(at(parts[i].box.high, axis), axis, kPadding) : -kFarAway;
      }
      made.child[i] = !used                       ? kLeaf
                      : parts[i].size() <= kBlock ? kLeaf | block(parts[i])
                                                  : node(parts[i], depth + 1);
    }
    tree.nodes_[number] = made;
    return number;
  }

  float inBoxes(double coordinate, int axis, double padding) const {
    return static_cast<float>((coordinate - at(tree.centre_, axis)) * tree.scale_ + padding);
  }

  /// Makes the block for a range of at most kBlock; gives its number.
  Index block(const Range& range) {
    const auto number = static_cast<Index>(tree.blocks_.size());
    TriangleBlock& made = tree.blocks_.emplace_back();
    for (std::size_t i = 0; i < range.size(); ++i) {
      const Index face = items[range.begin + i].face;
      const auto vertices = mesh.faceVertices(Face(face));
      const Vec3& corner = mesh.position(vertices[0]);
      const Vec3 edgeA = mesh.position(vertices[1]) - corner;
      const Vec3 edgeB = mesh.position(vertices[2]) - corner;
      const Vec3 normal = cross(edgeA, edgeB);
      for (int axis = 0; axis < 3; ++axis) {
        made.corner[axis][i] = at(corner, axis);
        made.edgeA[axis][i] = at(edgeA, axis);
        made.edgeB[axis][i] = at(edgeB, axis);
        made.normal[axis][i] = at(normal, axis);
        made.vertices[axis][i] = vertices[static_cast<std::size_t>(axis)];
      }
      made.face[i] = face;
    }
    return number;
  }
};

TriangleTree::TriangleTree(const SurfaceMesh& mesh) {
  Build build{*this, mesh, {}};
  build.items.reserve(mesh.faceCount());
  Box whole;
  for (const Face f : mesh.faces()) {
    Box box;
    for (const Vertex v : mesh.faceVertices(f)) box.add(mesh.position(v));
    whole.add(box);
    build.items.push_back({box, f});
  }
  centre_ = whole.centre();
  int exponent = 0;
  std::frexp(norm(whole.high - whole.low), &exponent);
  scale_ = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  build.node({0, build.items.size(), whole}, 0);
}

std::optional<RayHit> TriangleTree::firstHit(const Vec3& origin, const Vec3& direction,
                                             Index vertex, RayKernel kernel) const {
  const RayHit hit =
      kernel({nodes_.data(), blocks_.data(), {centre_.x, centre_.y, centre_.z}, scale_},
             {{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}, vertex});
  if (hit.face == kNoIndex) return std::nullopt;
  return hit;
}

}  // namespace girth
