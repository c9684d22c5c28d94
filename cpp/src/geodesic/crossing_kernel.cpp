// For any processor that the library is built for.
#define GIRTH_CROSSING_KERNEL crossPortable
#include "geodesic/crossing_kernel.inl"

namespace girth::geodesic {

#ifdef GIRTH_FOR_X86
CrossingResult crossAvx512(const CrossingBatch&, WindowRun* left, WindowRun* right);
CrossingResult crossAvx2(const CrossingBatch&, WindowRun* left, WindowRun* right);

std::span<const CrossingKernel> crossingKernels() {
  static constexpr CrossingKernel kernels[] = {crossAvx512, crossAvx2, crossPortable};
  static const std::size_t tooNew = __builtin_cpu_supports("avx512vl") ? 0
                                    : __builtin_cpu_supports("avx2")   ? 1
                                                                       : 2;
  return std::span(kernels).subspan(tooNew);
}
#else
std::span<const CrossingKernel> crossingKernels() {
  static constexpr CrossingKernel kernels[] = {crossPortable};
  return kernels;
}
#endif

}  // namespace girth::geodesic
