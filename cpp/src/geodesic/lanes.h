// Several doubles side by side: four with AVX2, otherwise two (SSE2, NEON, WebAssembly SIMD). Only
// operations that round each lane as a plain double would, so every width gives the same bits. With
// AVX-512 there are four too: a face seldom has windows for eight, but comparing and packing are
// one instruction each.
//
// Included by kernels alone, which are compiled once for each instruction set; nothing here has
// external linkage, so that no code for the wider set is ever shared with the other.
#pragma once

#include <math.h>

#if defined(__AVX2__) || defined(__SSE2__)
#include <immintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace girth::geodesic {
namespace {

#ifdef __AVX2__
constexpr int kLanes = 4;
#else
constexpr int kLanes = 2;
#endif

typedef double Lanes __attribute__((vector_size(8 * kLanes)));
/// The bits of each lane.
typedef long long LaneBits __attribute__((vector_size(8 * kLanes)));

/// The lanes for which a comparison holds.
#ifdef __AVX512VL__
typedef unsigned Mask;
inline Mask less(Lanes a, Lanes b) {
  return _mm256_cmp_pd_mask((__m256d)a, (__m256d)b, _CMP_LT_OQ);
}
inline Mask atMost(Lanes a, Lanes b) {
  return _mm256_cmp_pd_mask((__m256d)a, (__m256d)b, _CMP_LE_OQ);
}
#else
typedef LaneBits Mask;
inline Mask less(Lanes a, Lanes b) { return a < b; }
inline Mask atMost(Lanes a, Lanes b) { return a <= b; }
#endif

inline Lanes load(const double* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
inline void store(double* to, Lanes lanes) { __builtin_memcpy(to, &lanes, sizeof lanes); }
inline Lanes all(double value) { return value - Lanes{}; }

/// Where the mask is set, a; elsewhere b.
inline Lanes select(Mask where, Lanes a, Lanes b) {
#if defined(__AVX512VL__)
  return (Lanes)_mm256_mask_blend_pd((__mmask8)where, (__m256d)b, (__m256d)a);
#elif defined(__AVX2__)
  return (Lanes)_mm256_blendv_pd((__m256d)b, (__m256d)a, (__m256d)where);
#else
  return (Lanes)((where & (Mask)a) | (~where & (Mask)b));
#endif
}
/// a > b ? a : b, and a < b ? a : b: where either is not a number, b.
inline Lanes greater(Lanes a, Lanes b) {
#if defined(__AVX2__)
  return (Lanes)_mm256_max_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
  return (Lanes)_mm_max_pd((__m128d)a, (__m128d)b);
#elif defined(__wasm_simd128__)
  return (Lanes)wasm_f64x2_pmax((v128_t)b, (v128_t)a);
#else
  return select(a > b, a, b);
#endif
}
inline Lanes smaller(Lanes a, Lanes b) {
#if defined(__AVX2__)
  return (Lanes)_mm256_min_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
  return (Lanes)_mm_min_pd((__m128d)a, (__m128d)b);
#elif defined(__wasm_simd128__)
  return (Lanes)wasm_f64x2_pmin((v128_t)b, (v128_t)a);
#else
  return select(a < b, a, b);
#endif
}
inline Lanes absolute(Lanes a) { return (Lanes)((LaneBits)a & 0x7FFFFFFFFFFFFFFFll); }

inline Lanes squareRoot(Lanes a) {
#if defined(__AVX2__)
  return (Lanes)_mm256_sqrt_pd((__m256d)a);
#elif defined(__SSE2__)
  return (Lanes)_mm_sqrt_pd((__m128d)a);
#elif defined(__wasm_simd128__)
  return (Lanes)wasm_f64x2_sqrt((v128_t)a);
#else
  for (int i = 0; i < kLanes; ++i) a[i] = sqrt(a[i]);
  return a;
#endif
}

/// One bit for each lane, lane 0 the lowest.
inline unsigned bits(Mask mask) {
#if defined(__AVX512VL__)
  return mask;
#elif defined(__AVX2__)
  return (unsigned)_mm256_movemask_pd((__m256d)mask);
#elif defined(__SSE2__)
  return (unsigned)_mm_movemask_pd((__m128d)mask);
#elif defined(__wasm_simd128__)
  return (unsigned)wasm_i64x2_bitmask((v128_t)mask);
#else
  unsigned result = 0;
  for (int i = 0; i < kLanes; ++i) result |= (mask[i] ? 1u : 0u) << i;
  return result;
#endif
}

/// The lowest of some lanes, at least one.
inline unsigned lowest(unsigned lanes) { return (unsigned)__builtin_ctz(lanes); }

/// The first `count` lanes.
inline Mask firstLanes(unsigned count) {
#if defined(__AVX512VL__)
  return count < kLanes ? (1u << count) - 1 : (1u << kLanes) - 1;
#elif defined(__wasm_simd128__)
  return (Mask)wasm_i32x4_gt(wasm_i32x4_splat((int)count), wasm_i32x4_const(0, 0, 1, 1));
#else
  LaneBits lane;
  for (int i = 0; i < kLanes; ++i) lane[i] = i;
  return lane < (long long)count - LaneBits{};
#endif
}

/// Moves the lanes whose bits are set to the front, in their order.
inline Lanes pack(Lanes a, unsigned chosen) {
#if defined(__AVX512VL__)
  return (Lanes)_mm256_maskz_compress_pd((__mmask8)chosen, (__m256d)a);
#elif defined(__AVX2__)
  // For each choice of lanes, the 32-bit halves to take.
  alignas(32) static const int kOrder[16][8] = {
      {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {2, 3, 2, 3, 4, 5, 6, 7},
      {0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 2, 3, 4, 5, 6, 7}, {0, 1, 4, 5, 4, 5, 6, 7},
      {2, 3, 4, 5, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {6, 7, 2, 3, 4, 5, 6, 7},
      {0, 1, 6, 7, 4, 5, 6, 7}, {2, 3, 6, 7, 4, 5, 6, 7}, {0, 1, 2, 3, 6, 7, 6, 7},
      {4, 5, 6, 7, 4, 5, 6, 7}, {0, 1, 4, 5, 6, 7, 6, 7}, {2, 3, 4, 5, 6, 7, 6, 7},
      {0, 1, 2, 3, 4, 5, 6, 7}};
  return (Lanes)_mm256_permutevar8x32_epi32((__m256i)a,
                                            _mm256_load_si256((const __m256i*)kOrder[chosen]));
#else
  const Lanes second = {a[1], a[1]};
  const Mask only = (chosen == 2 ? -1ll : 0ll) - LaneBits{};
  return select(only, second, a);
#endif
}

/// The smallest of the lanes.
inline double smallest(Lanes a) {
#ifdef __wasm_simd128__
  return smaller(a, Lanes{a[1], a[1]})[0];  // without a jump: see min_max.h
#else
  double result = a[0];
  for (int i = 1; i < kLanes; ++i) result = a[i] < result ? a[i] : result;
  return result;
#endif
}

}  // namespace
}  // namespace girth::geodesic
