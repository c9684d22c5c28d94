// The kernel itself; compiled once for each instruction set, in files that name it
// GIRTH_RAY_KERNEL. Nothing but the kernel has external linkage, as in geodesic/lanes.h.

#include "descriptors/ray_kernel.h"
#include "geodesic/lanes.h"

namespace girth {
namespace {

using geodesic::all;
using geodesic::atMost;
using geodesic::kLanes;
using geodesic::LaneBits;
using geodesic::Lanes;
using geodesic::less;
using geodesic::load;
using geodesic::Mask;

/// Floats side by side, for boxes: all of a node with AVX2, else half of them.
#ifdef __AVX2__
constexpr std::size_t kFloats = 8;
#else
constexpr std::size_t kFloats = 4;
#endif
typedef float Floats __attribute__((vector_size(4 * kFloats)));
typedef int FloatMask __attribute__((vector_size(4 * kFloats)));

inline Floats loadFloats(const float* from) {
  Floats floats;
  __builtin_memcpy(&floats, from, sizeof floats);
  return floats;
}
inline Floats allFloats(float value) { return value - Floats{}; }

/// a > b ? a : b, and a < b ? a : b: where either is not a number, b.
inline Floats greaterFloats(Floats a, Floats b) {
#if defined(__AVX2__)
  return (Floats)_mm256_max_ps((__m256)a, (__m256)b);
#elif defined(__SSE2__)
  return (Floats)_mm_max_ps((__m128)a, (__m128)b);
#elif defined(__wasm_simd128__)
  return (Floats)wasm_f32x4_pmax((v128_t)b, (v128_t)a);
#else
  const FloatMask mask = a > b;
  return (Floats)((mask & (FloatMask)a) | (~mask & (FloatMask)b));
#endif
}
inline Floats smallerFloats(Floats a, Floats b) {
#if defined(__AVX2__)
  return (Floats)_mm256_min_ps((__m256)a, (__m256)b);
#elif defined(__SSE2__)
  return (Floats)_mm_min_ps((__m128)a, (__m128)b);
#elif defined(__wasm_simd128__)
  return (Floats)wasm_f32x4_pmin((v128_t)b, (v128_t)a);
#else
  const FloatMask mask = a < b;
  return (Floats)((mask & (FloatMask)a) | (~mask & (FloatMask)b));
#endif
}
/// One bit for each lane, lane 0 the lowest.
inline unsigned bitsOfFloats(FloatMask mask) {
#if defined(__AVX2__)
  return (unsigned)_mm256_movemask_ps((__m256)mask);
#elif defined(__SSE2__)
  return (unsigned)_mm_movemask_ps((__m128)mask);
#elif defined(__wasm_simd128__)
  return (unsigned)wasm_i32x4_bitmask((v128_t)mask);
#else
  unsigned result = 0;
  for (std::size_t i = 0; i < kFloats; ++i) result |= (mask[i] ? 1u : 0u) << i;
  return result;
#endif
}

/// Nodes that wait while a ray goes down: seven at each level.
constexpr std::size_t kStack = (kBranches - 1) * kDeepest + 1;
/// Boxes are padded by far more than rounding moves (TriangleTree); a box must not be lost to the
/// last bit of the distance up to which they count either.
constexpr float kSlack = 1.000001f;

struct Lanes3 {
  Lanes x, y, z;
};
inline Lanes3 load3(const double (&from)[3][kBlock], std::size_t first) {
  return {load(from[0] + first), load(from[1] + first), load(from[2] + first)};
}
inline Lanes dot(const Lanes3& a, const Lanes3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Takes the nearest triangle of a block where it is nearer than `best`.
inline bool meetBlock(const TriangleBlock& block, const Lanes3& origin, const Lanes3& direction,
                      Index vertex, RayHit& best) {
  bool nearer = false;
  for (std::size_t first = 0; first < kBlock; first += kLanes) {
    // Möller and Trumbore 1997, with the normal computed beforehand: from corner + u·edgeA +
    // v·edgeB = origin + distance·direction, all times the determinant, whose sign goes over.
    const Lanes3 corner = load3(block.corner, first), normal = load3(block.normal, first);
    const Lanes3 to{corner.x - origin.x, corner.y - origin.y, corner.z - origin.z};
    const Lanes3 turned{to.y * direction.z - to.z * direction.y,
                        to.z * direction.x - to.x * direction.z,
                        to.x * direction.y - to.y * direction.x};
    const Lanes determinant = dot(normal, direction), zero = {};
    const LaneBits sign = (LaneBits)determinant & (LaneBits)(all(-0.0));
    const Lanes size = (Lanes)((LaneBits)determinant ^ sign);
    const Lanes u = (Lanes)((LaneBits)dot(load3(block.edgeB, first), turned) ^ sign);
    const Lanes v = (Lanes)((LaneBits)-dot(load3(block.edgeA, first), turned) ^ sign);
    const Lanes along = (Lanes)((LaneBits)dot(normal, to) ^ sign);
    const Mask met = atMost(zero, u) & atMost(zero, v) & atMost(u + v, size) & less(zero, along) &
                     less(zero, size);
    unsigned left = geodesic::bits(met);
    if (left == 0) continue;
    const Lanes distances = along / size;
    for (; left != 0; left &= left - 1) {
      const auto lane = (unsigned)__builtin_ctz(left);
      const std::size_t i = first + lane;
      const double distance = distances[lane];
      if (distance > best.distance) continue;
      if (distance == best.distance && block.face[i] > best.face) continue;
      if (block.vertices[0][i] == vertex || block.vertices[1][i] == vertex ||
          block.vertices[2][i] == vertex) {
        continue;
      }
      best = {distance, block.face[i], determinant[lane] > 0};
      nearer = true;
    }
  }
  return nearer;
}

}  // namespace

RayHit GIRTH_RAY_KERNEL(const TreeView& tree, const Ray& ray) {
  Floats start[3], inverse[3];
  unsigned nearSide[3], farSide[3];
  for (unsigned axis = 0; axis < 3; ++axis) {
    start[axis] = allFloats((float)((ray.origin[axis] - tree.centre[axis]) * tree.scale));
    // A ray along a side never leaves the slab: a huge number does as well as infinity.
    const auto d = (float)ray.direction[axis];
    const bool backwards = d < 0;
    nearSide[axis] = backwards ? axis + 3 : axis;
    farSide[axis] = backwards ? axis : axis + 3;
    const float size = backwards ? -d : d;
    inverse[axis] = allFloats(size > 1e-20f ? 1 / d : (backwards ? -1e20f : 1e20f));
  }
  const Lanes3 origin{all(ray.origin[0]), all(ray.origin[1]), all(ray.origin[2])};
  const Lanes3 direction{all(ray.direction[0]), all(ray.direction[1]), all(ray.direction[2])};
  RayHit best{__DBL_MAX__, kNoIndex, false};
  float nearest = __FLT_MAX__;  // the distance of `best` among the boxes

  struct Waiting {
    float enters;
    Index child;
  } stack[kStack];
  std::size_t depth = 0;
  stack[depth++] = {0, 0};
  while (depth > 0) {
    const Waiting next = stack[--depth];
    if (next.enters > nearest) continue;
    if ((next.child & kLeaf) != 0) {
      if (meetBlock(tree.blocks[next.child & ~kLeaf], origin, direction, ray.vertex, best)) {
        const double scaled = best.distance * tree.scale;
        nearest = scaled < 1e30 ? (float)scaled * kSlack : 1e30f;
      }
      continue;
    }
    const TreeNode& node = tree.nodes[next.child];
    const std::size_t base = depth;
    for (std::size_t first = 0; first < kBranches; first += kFloats) {
      Floats enters = {}, leaves = allFloats(nearest);
      for (unsigned axis = 0; axis < 3; ++axis) {
        const Floats in = loadFloats(node.sides[nearSide[axis]] + first);
        const Floats out = loadFloats(node.sides[farSide[axis]] + first);
        enters = greaterFloats((in - start[axis]) * inverse[axis], enters);
        leaves = smallerFloats((out - start[axis]) * inverse[axis], leaves);
      }
      for (unsigned left = bitsOfFloats(enters <= leaves); left != 0; left &= left - 1) {
        const auto lane = (unsigned)__builtin_ctz(left);
        const Waiting met{enters[lane], node.child[first + lane]};
        // The nearest on top.
        std::size_t place = depth++;
        for (; place > base && stack[place - 1].enters < met.enters; --place) {
          stack[place] = stack[place - 1];
        }
        stack[place] = met;
      }
    }
  }
  return best;
}

}  // namespace girth
