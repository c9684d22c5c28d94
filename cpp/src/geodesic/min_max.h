// The lesser and the larger of two numbers, without a jump.
//
// Browsers make a jump of every choice between two floating-point numbers of a WebAssembly module.
// The processor cannot foresee the engine's, and they cost it a tenth of its time. Between lanes of
// vectors browsers choose without; other compilers do so anyway.
#pragma once

#include <algorithm>

#ifdef __wasm_simd128__
#include <wasm_simd128.h>
#endif

namespace girth::geodesic {

/// std::min and std::max, bit for bit; also of floats, which are doubles without rounding.
inline double lesser(double a, double b) {
#ifdef __wasm_simd128__
  return wasm_f64x2_extract_lane(wasm_f64x2_pmin(wasm_f64x2_splat(a), wasm_f64x2_splat(b)), 0);
#else
  return std::min(a, b);
#endif
}
inline double larger(double a, double b) {
#ifdef __wasm_simd128__
  return wasm_f64x2_extract_lane(wasm_f64x2_pmax(wasm_f64x2_splat(a), wasm_f64x2_splat(b)), 0);
#else
  return std::max(a, b);
#endif
}

}  // namespace girth::geodesic
