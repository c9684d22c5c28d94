// For x86 processors with AVX2: compiled with -mavx2, and called only where the processor has it.
#define GIRTH_CROSSING_KERNEL crossAvx2
#include "geodesic/crossing_kernel.inl"
