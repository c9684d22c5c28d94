// The way of a ray through a tree of boxes, and the face that it meets first there.
#pragma once

#include <cstddef>

#include "girth/surface_mesh.h"

namespace girth {

inline constexpr std::size_t kBranches = 8;
inline constexpr std::size_t kBlock = 4;
/// Marks a child that is a block of triangles.
inline constexpr Index kLeaf = 0x80000000u;
/// Levels of nodes that a tree has at most.
inline constexpr std::size_t kDeepest = 36;

/// Up to eight boxes and what is in them. Boxes that are not needed are turned inside out.
struct alignas(64) TreeNode {
  float sides[6][kBranches];  ///< the lower x, y, z; the upper x, y, z
  Index child[kBranches];     ///< a node; or, with kLeaf, a block
};

/// Up to four triangles: a corner, the two edges from there, and their cross product, which is zero
/// where there is none.
struct alignas(32) TriangleBlock {
  double corner[3][kBlock], edgeA[3][kBlock], edgeB[3][kBlock], normal[3][kBlock];
  Index vertices[3][kBlock];
  Index face[kBlock];
};

/// Boxes are given in single precision, in units of `1 / scale`, from `centre`.
struct TreeView {
  const TreeNode* nodes;
  const TriangleBlock* blocks;
  double centre[3];
  double scale;
};

struct Ray {
  double origin[3], direction[3];
  Index vertex;  ///< faces at it are passed by; kNoIndex: none
};

/// Where a ray meets a face.
struct RayHit {
  double distance;  ///< in lengths of the ray's direction
  Index face;       ///< kNoIndex: it meets none
  bool fromBehind;  ///< the ray comes from inside: it runs along the face's normal
};

using RayKernel = RayHit (*)(const TreeView&, const Ray&);

/// The fastest kernel that this processor can run, and the one that any can. Both give the same
/// bits.
RayKernel rayKernel();
RayKernel portableRayKernel();

}  // namespace girth
