// The first face that a ray meets: a tree of boxes over the faces of a surface.
//
// A bounding volume hierarchy with eight children a node, whose boxes a ray is tested against all
// at once (Wald, Benthin and Boulos 2008), built top down by the surface area heuristic with bins
// (Wald 2007); at its ends are blocks of four triangles, met all at once too. Boxes are of single
// precision, wider than rounding moves them; faces are met in double precision, from + − × ÷ alone,
// so that every platform, whatever the number of lanes, gets the same bits.
#pragma once

#include <optional>
#include <vector>

#include "descriptors/ray_kernel.h"
#include "girth/surface_mesh.h"

namespace girth {

/// Immutable once built: threads may share it.
class TriangleTree {
 public:
  /// O(n log n).
  explicit TriangleTree(const SurfaceMesh& mesh);

  /// The nearest face that the ray meets in front of its origin; faces at `vertex` (the ray starts
  /// there) are passed by. Where two faces are equally near, the one with the smaller number. A ray
  /// through an edge or a corner meets the faces at it or just misses them, as rounding has it.
  std::optional<RayHit> firstHit(const Vec3& origin, const Vec3& direction, Index vertex,
                                 RayKernel kernel = rayKernel()) const;

 private:
  struct Build;

  Vec3 centre_;      // the middle of the surface; boxes are relative to it
  double scale_{1};  // factor of boxes, a power of two: the surface is about as large as 1
  std::vector<TreeNode> nodes_;
  std::vector<TriangleBlock> blocks_;
};

}  // namespace girth
