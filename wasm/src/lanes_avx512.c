/* The fast stage for x86 with AVX-512. */
#include "lanes.h"

#ifdef __AVX512F__
#define LANES avx512
#include "lanes_kernel.h"
#endif
