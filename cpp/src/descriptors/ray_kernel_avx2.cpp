// For x86 processors with AVX2: compiled with -mavx2, and called only where the processor has it.
#define GIRTH_RAY_KERNEL firstHitAvx2
#include "descriptors/ray_kernel.inl"
