/* The fast stage for x86 with AVX2. */
#include "lanes.h"

#ifdef __AVX2__
#define LANES avx2
#include "lanes_kernel.h"
#endif
