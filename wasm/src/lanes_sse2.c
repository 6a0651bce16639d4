/* The fast stage for x86 with SSE2. */
#include "lanes.h"

#ifdef __SSE2__
#define LANES sse2
#include "lanes_kernel.h"
#endif
