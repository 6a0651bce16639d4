/* Integers of 64 bits. */
#include "halves.h"

#include <stdbool.h>
#ifdef __wasm_simd128__
#include <wasm_simd128.h>
#endif

static uint32_t step_of(const uint32_t *low, uint32_t count) {
  if (count < 2) return 0;
  const uint32_t step = low[1] - low[0];
  bool is_same = true;
  for (uint32_t i = 2; i < count && is_same; ++i) is_same = low[i] - low[i - 1] == step;
  return is_same ? step : 0;
}

#ifdef __wasm_simd128__
static int32_t least_lane(v128_t v) {
  v = wasm_i32x4_min(v, wasm_i64x2_shuffle(v, v, 1, 0));
  return wasm_i32x4_extract_lane(wasm_i32x4_min(v, wasm_i32x4_shuffle(v, v, 1, 0, 3, 2)), 0);
}

/* Four at a time; returns how many. */
static uint32_t take_fours(const uint32_t *words, uint32_t count, uint32_t *low, hl_halves *known) {
  if (count < 4) return 0;
  v128_t high = wasm_i32x4_splat(0), least = wasm_i32x4_splat(INT32_MAX), greatest = wasm_i32x4_splat(INT32_MIN);
  uint32_t i = 0;
  for (; i + 4 <= count; i += 4) {
    const v128_t a = wasm_v128_load(words + 2 * i), b = wasm_v128_load(words + 2 * i + 4);
    const v128_t own = wasm_i32x4_shuffle(a, b, 0, 2, 4, 6);
    high = wasm_v128_or(high, wasm_i32x4_shuffle(a, b, 1, 3, 5, 7));
    least = wasm_i32x4_min(least, own);
    greatest = wasm_i32x4_max(greatest, own);
    wasm_v128_store(low + i, own);
  }
  known->high = (uint32_t)wasm_v128_any_true(high);
  known->least = least_lane(least);
  known->greatest = ~least_lane(wasm_v128_not(greatest));
  return i;
}
#else
static uint32_t take_fours(const uint32_t *words, uint32_t count, uint32_t *low, hl_halves *known) {
  (void)words, (void)count, (void)low, (void)known;
  return 0;
}
#endif

hl_halves hl_low_halves(const uint32_t *words, uint32_t count, uint32_t *low) {
  hl_halves known = {0, INT32_MAX, INT32_MIN, 0};
  for (uint32_t i = take_fours(words, count, low, &known); i < count; ++i) {
    const int32_t own = (int32_t)words[2 * i];
    known.high |= words[2 * i + 1];
    low[i] = (uint32_t)own;
    if (own < known.least) known.least = own;
    if (own > known.greatest) known.greatest = own;
  }
  known.step = step_of(low, count);
  return known;
}
