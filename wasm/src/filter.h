/* The certified filter: valid, invalid, or undecided in doubles, from the Bernstein coefficients and their error bounds
   (docs/algorithm.md 7). */
#ifndef HL_FILTER_H
#define HL_FILTER_H

#include "hexlens.h"

/* For coefficients in scaled units. Stops at the first value that is certainly negative. */
hl_verdict filtered_verdict(const double bernstein[HL_BERNSTEIN]);

#endif
