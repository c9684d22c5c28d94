// For any processor that the library is built for.
#define GIRTH_CROSSING_KERNEL crossPortable
#include "geodesic/crossing_kernel.inl"

namespace girth::geodesic {

CrossingKernel portableCrossingKernel() { return crossPortable; }

#ifdef GIRTH_WITH_AVX2
CrossingResult crossAvx2(const CrossingBatch&, WindowRun* left, WindowRun* right);

CrossingKernel crossingKernel() {
  return __builtin_cpu_supports("avx2") ? crossAvx2 : crossPortable;
}
#else
CrossingKernel crossingKernel() { return crossPortable; }
#endif

}  // namespace girth::geodesic
