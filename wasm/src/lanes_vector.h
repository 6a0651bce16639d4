/* Vectors of DOUBLES doubles or FLOATS floats and the few operations that C's operators on vectors do not name, for the
   instruction set this is compiled for. smaller_of(a, b) is b < a ? b : a everywhere, so a NaN in b is passed over. */
#ifndef HL_LANES_VECTOR_H
#define HL_LANES_VECTOR_H

#include <stdint.h>

#if defined __wasm_simd128__
#include <wasm_simd128.h>
enum { DOUBLES = 2 };
#elif defined __AVX512F__
#include <immintrin.h>
enum { DOUBLES = 8 };
#elif defined __AVX2__
#include <immintrin.h>
enum { DOUBLES = 4 };
#elif defined __SSE2__
#include <emmintrin.h>
enum { DOUBLES = 2 };
#endif
enum { FLOATS = 2 * DOUBLES };

typedef double doubles __attribute__((vector_size(8 * DOUBLES)));
typedef float floats __attribute__((vector_size(8 * DOUBLES)));
typedef int64_t double_bits __attribute__((vector_size(8 * DOUBLES)));
typedef uint64_t double_words __attribute__((vector_size(8 * DOUBLES)));
typedef int32_t float_bits __attribute__((vector_size(8 * DOUBLES)));

static inline doubles all_doubles(double x) { return (doubles){0} + x; }
static inline floats all_floats(float x) { return (floats){0} + x; }

static inline doubles magnitude_of(doubles x) { return (doubles)((double_bits)x & INT64_MAX); }
static inline floats magnitude_of_floats(floats x) { return (floats)((float_bits)x & INT32_MAX); }

#if defined __wasm_simd128__

static inline doubles smaller_of(doubles a, doubles b) { return (doubles)wasm_f64x2_pmin((v128_t)a, (v128_t)b); }
static inline doubles larger_of(doubles a, doubles b) { return (doubles)wasm_f64x2_pmax((v128_t)a, (v128_t)b); }
static inline floats smaller_floats(floats a, floats b) { return (floats)wasm_f32x4_pmin((v128_t)a, (v128_t)b); }
static inline floats larger_floats(floats a, floats b) { return (floats)wasm_f32x4_pmax((v128_t)a, (v128_t)b); }
/* No operation: what follows reads `numbers` from memory. V8 mixes all arithmetic between reads and writes breadth first, so that far
   more numbers are alive than there are registers; reads and writes keep their order, and the arithmetic of one corner together. */
static inline void order_by_memory(const void *numbers) { __asm__ volatile("" : : "r"(numbers) : "memory"); }
/* One bit a lane, from masks as comparisons give them. */
static inline unsigned lane_bits(double_bits mask) { return wasm_i64x2_bitmask((v128_t)mask); }
static inline unsigned float_lane_bits(float_bits mask) { return wasm_i32x4_bitmask((v128_t)mask); }

/* Coordinates 2g and 2g + 1 of two elements. */
static inline void load_pair(const double *hexahedra, int g, doubles out[2]) {
  v128_t a = wasm_v128_load(hexahedra + 2 * g), b = wasm_v128_load(hexahedra + 24 + 2 * g);
  out[0] = (doubles)wasm_i64x2_shuffle(a, b, 0, 2);
  out[1] = (doubles)wasm_i64x2_shuffle(a, b, 1, 3);
}

/* Coordinates 0 to 23 of four elements relative to their vertex 0, in floats. */
static inline void load_relative(const double *hexahedra, floats out[24]) {
  v128_t row[4][6];
  for (int h = 0; h < 4; ++h) {
    const double *p = hexahedra + 24 * h;
    v128_t xy = wasm_v128_load(p), z_ = wasm_v128_load64_splat(p + 2), zx = wasm_i64x2_shuffle(z_, xy, 0, 2),
           yz = wasm_i64x2_shuffle(xy, z_, 1, 2);
    const v128_t origin[3] = {xy, zx, yz};
    for (int g = 0; g < 6; ++g) {
      v128_t low = wasm_f64x2_sub(wasm_v128_load(p + 4 * g), origin[(2 * g) % 3]);
      v128_t high = wasm_f64x2_sub(wasm_v128_load(p + 4 * g + 2), origin[(2 * g + 1) % 3]);
      row[h][g] = wasm_i64x2_shuffle(wasm_f32x4_demote_f64x2_zero(low), wasm_f32x4_demote_f64x2_zero(high), 0, 2);
    }
  }
  for (int g = 0; g < 6; ++g) {
    v128_t a = wasm_i32x4_shuffle(row[0][g], row[1][g], 0, 4, 1, 5),
           b = wasm_i32x4_shuffle(row[2][g], row[3][g], 0, 4, 1, 5),
           c = wasm_i32x4_shuffle(row[0][g], row[1][g], 2, 6, 3, 7),
           d = wasm_i32x4_shuffle(row[2][g], row[3][g], 2, 6, 3, 7);
    out[4 * g] = (floats)wasm_i64x2_shuffle(a, b, 0, 2);
    out[4 * g + 1] = (floats)wasm_i64x2_shuffle(a, b, 1, 3);
    out[4 * g + 2] = (floats)wasm_i64x2_shuffle(c, d, 0, 2);
    out[4 * g + 3] = (floats)wasm_i64x2_shuffle(c, d, 1, 3);
  }
}

#else

/* Native compilers order arithmetic by the registers that they have. */
static inline void order_by_memory(const void *numbers) { (void)numbers; }

#if defined __AVX512F__
#define WIDE(operation) _mm512_##operation
typedef __m512d wide_doubles;
typedef __m512 wide_floats;
static inline unsigned lane_bits(double_bits mask) {
  return _mm512_cmplt_epi64_mask((__m512i)mask, _mm512_setzero_si512());
}
static inline unsigned float_lane_bits(float_bits mask) {
  return _mm512_cmplt_epi32_mask((__m512i)mask, _mm512_setzero_si512());
}
#elif defined __AVX2__
#define WIDE(operation) _mm256_##operation
typedef __m256d wide_doubles;
typedef __m256 wide_floats;
static inline unsigned lane_bits(double_bits mask) { return (unsigned)_mm256_movemask_pd((__m256d)mask); }
static inline unsigned float_lane_bits(float_bits mask) { return (unsigned)_mm256_movemask_ps((__m256)mask); }
#else
#define WIDE(operation) _mm_##operation
typedef __m128d wide_doubles;
typedef __m128 wide_floats;
static inline unsigned lane_bits(double_bits mask) { return (unsigned)_mm_movemask_pd((__m128d)mask); }
static inline unsigned float_lane_bits(float_bits mask) { return (unsigned)_mm_movemask_ps((__m128)mask); }
#endif

/* x86's minimum of (x, y) is x < y ? x : y. */
static inline doubles smaller_of(doubles a, doubles b) {
  return (doubles)WIDE(min_pd)((wide_doubles)b, (wide_doubles)a);
}
static inline doubles larger_of(doubles a, doubles b) {
  return (doubles)WIDE(max_pd)((wide_doubles)b, (wide_doubles)a);
}
static inline floats smaller_floats(floats a, floats b) { return (floats)WIDE(min_ps)((wide_floats)b, (wide_floats)a); }
static inline floats larger_floats(floats a, floats b) { return (floats)WIDE(max_ps)((wide_floats)b, (wide_floats)a); }

/* The 128-bit parts side by side. */
static inline wide_doubles beside_doubles(const double *rows, int stride) {
#if defined __AVX512F__
  __m512d all = _mm512_castpd128_pd512(_mm_loadu_pd(rows));
  all = (__m512d)_mm512_inserti32x4((__m512i)all, (__m128i)_mm_loadu_pd(rows + stride), 1);
  all = (__m512d)_mm512_inserti32x4((__m512i)all, (__m128i)_mm_loadu_pd(rows + 2 * stride), 2);
  return (__m512d)_mm512_inserti32x4((__m512i)all, (__m128i)_mm_loadu_pd(rows + 3 * stride), 3);
#elif defined __AVX2__
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(rows)), _mm_loadu_pd(rows + stride), 1);
#else
  (void)stride;
  return _mm_loadu_pd(rows);
#endif
}

static inline wide_floats beside_floats(const __m128 *rows, int stride) {
#if defined __AVX512F__
  __m512 all = _mm512_castps128_ps512(rows[0]);
  all = _mm512_insertf32x4(all, rows[stride], 1);
  all = _mm512_insertf32x4(all, rows[2 * stride], 2);
  return _mm512_insertf32x4(all, rows[3 * stride], 3);
#elif defined __AVX2__
  return _mm256_insertf128_ps(_mm256_castps128_ps256(rows[0]), rows[stride], 1);
#else
  (void)stride;
  return rows[0];
#endif
}

static inline void load_pair(const double *hexahedra, int g, doubles out[2]) {
  wide_doubles even = beside_doubles(hexahedra + 2 * g, 48), odd = beside_doubles(hexahedra + 24 + 2 * g, 48);
  out[0] = (doubles)WIDE(unpacklo_pd)(even, odd);
  out[1] = (doubles)WIDE(unpackhi_pd)(even, odd);
}

/* Coordinates 4g to 4g + 3 of one element relative to its vertex 0, in floats. */
static inline void relative_rows(const double *p, __m128 row[6]) {
#if defined __AVX2__
  __m256d first = _mm256_loadu_pd(p);
  const __m256d origin[3] = {_mm256_permute4x64_pd(first, 0x24), _mm256_permute4x64_pd(first, 0x49),
                             _mm256_permute4x64_pd(first, 0x92)};
  for (int g = 0; g < 6; ++g) row[g] = _mm256_cvtpd_ps(_mm256_sub_pd(_mm256_loadu_pd(p + 4 * g), origin[g % 3]));
#else
  __m128d xy = _mm_loadu_pd(p), z = _mm_load1_pd(p + 2);
  const __m128d origin[3] = {xy, _mm_unpacklo_pd(z, xy), _mm_shuffle_pd(xy, z, 1)};
  for (int g = 0; g < 6; ++g) {
    __m128 low = _mm_cvtpd_ps(_mm_sub_pd(_mm_loadu_pd(p + 4 * g), origin[(2 * g) % 3]));
    __m128 high = _mm_cvtpd_ps(_mm_sub_pd(_mm_loadu_pd(p + 4 * g + 2), origin[(2 * g + 1) % 3]));
    row[g] = _mm_movelh_ps(low, high);
  }
#endif
}

static inline void load_relative(const double *hexahedra, floats out[24]) {
  __m128 rows[FLOATS][6];
  for (int h = 0; h < FLOATS; ++h) relative_rows(hexahedra + 24 * h, rows[h]);
  for (int g = 0; g < 6; ++g) {
    wide_floats a = beside_floats(&rows[0][g], 24), b = beside_floats(&rows[1][g], 24),
                c = beside_floats(&rows[2][g], 24), d = beside_floats(&rows[3][g], 24);
    wide_doubles ab_low = (wide_doubles)WIDE(unpacklo_ps)(a, b), cd_low = (wide_doubles)WIDE(unpacklo_ps)(c, d),
                 ab_high = (wide_doubles)WIDE(unpackhi_ps)(a, b), cd_high = (wide_doubles)WIDE(unpackhi_ps)(c, d);
    out[4 * g] = (floats)WIDE(unpacklo_pd)(ab_low, cd_low);
    out[4 * g + 1] = (floats)WIDE(unpackhi_pd)(ab_low, cd_low);
    out[4 * g + 2] = (floats)WIDE(unpacklo_pd)(ab_high, cd_high);
    out[4 * g + 3] = (floats)WIDE(unpackhi_pd)(ab_high, cd_high);
  }
}

#endif

#endif
