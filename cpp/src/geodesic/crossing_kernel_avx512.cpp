// For x86 processors with AVX-512 (VL: on vectors of four doubles): compiled with -mavx512vl, and
// called only where the processor has it.
#define GIRTH_CROSSING_KERNEL crossAvx512
#include "geodesic/crossing_kernel.inl"
