/* The least jacdet over the whole element, bracketed: docs/algorithm.md 8. */
#ifndef HL_VOLUME_H
#define HL_VOLUME_H

#include "hexlens.h"

/* The bracket from coefficients in any unit, each off by at most `error`, and a candidate on the
   boundary to begin with. upper - lower is at most 2^-34 of the largest coefficient and twice the
   error; wider only where WORK_LIMIT boxes were not enough. The position is left to the caller. */
hl_volume_minimum bracketed_volume_minimum(const double bernstein[HL_BERNSTEIN], double error,
                                           const hl_candidate *start);

#endif
