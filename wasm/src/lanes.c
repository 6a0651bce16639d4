/* The fast stages that this machine runs. HL_X86_LANES: the build contains those for x86. */
#include "batch.h"

int usable_lanes(const lane_kernels *list[4]) {
  int count = 0;
#if defined __wasm_simd128__
  list[count++] = &lanes_wasm;
#elif defined HL_X86_LANES
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) list[count++] = &lanes_avx512;
  if (__builtin_cpu_supports("avx2")) list[count++] = &lanes_avx2;
  list[count++] = &lanes_sse2;
#else
  (void)list;
#endif
  return count;
}

const lane_kernels *best_lanes(void) {
  const lane_kernels *list[4];
  return usable_lanes(list) > 0 ? list[0] : 0;
}
