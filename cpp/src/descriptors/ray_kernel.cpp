// For any processor that the library is built for.
#define GIRTH_RAY_KERNEL firstHitPortable
#include "descriptors/ray_kernel.inl"

namespace girth {

RayKernel portableRayKernel() { return firstHitPortable; }

#ifdef GIRTH_FOR_X86
RayHit firstHitAvx2(const TreeView& tree, const Ray& ray);

RayKernel rayKernel() { return __builtin_cpu_supports("avx2") ? firstHitAvx2 : firstHitPortable; }
#else
RayKernel rayKernel() { return firstHitPortable; }
#endif

}  // namespace girth
