// The first face that a ray meets: a tree of boxes over the faces of a surface.
//
// A bounding volume hierarchy with four children a node, whose boxes a ray is tested against all at
// once (Wald, Benthin and Boulos 2008), built top down by the surface area heuristic with bins
// (Wald 2007). Boxes are of single precision, rounded outwards; faces are met in double precision,
// from + − × ÷ alone, so that every platform gets the same bits.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth {

/// Where a ray meets a face.
struct RayHit {
  double distance;  ///< in lengths of the ray's direction
  Index face;
  bool fromBehind;  ///< the ray comes from inside: it runs along the face's normal
};

/// Immutable once built: threads may share it.
class TriangleTree {
 public:
  /// O(n log n).
  explicit TriangleTree(const SurfaceMesh& mesh);

  /// The nearest face that the ray meets in front of its origin; faces at `vertex` (the ray starts
  /// there) are passed by. Where two faces are equally near, the one with the smaller number. A ray
  /// through an edge or a corner meets the faces at it or just misses them, as rounding has it.
  std::optional<RayHit> firstHit(const Vec3& origin, const Vec3& direction, Index vertex) const;

 private:
  static constexpr std::size_t kWidth = 4;
  static constexpr Index kLeaf = 0x80000000u;

  /// Up to four boxes and what is in them. Empty boxes are turned inside out.
  struct alignas(64) Node {
    float low[3][kWidth], high[3][kWidth];
    /// A node; or, with kLeaf, the first of `count` triangles.
    std::array<Index, kWidth> child;
    std::array<Index, kWidth> count;
  };
  /// A corner and the two edges from there.
  struct Triangle {
    Vec3 corner, edgeA, edgeB;
    std::array<Index, 3> vertices;
    Index face;
  };
  struct Build;

  Vec3 centre_;  // of the surface; boxes are told from there
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
};

}  // namespace girth
