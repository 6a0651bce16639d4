/* The fast stage for WebAssembly with 128-bit vectors. */
#include "lanes.h"

#ifdef __wasm_simd128__
#define LANES wasm
#include "lanes_kernel.h"
#endif
