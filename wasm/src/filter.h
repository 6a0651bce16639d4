/* The certified filter: valid, invalid, or undecided in doubles, from the Bernstein coefficients and their error bounds
   (docs/algorithm.md 7). */
#ifndef HL_FILTER_H
#define HL_FILTER_H

#include "hexlens.h"

/* For coefficients in scaled units. Stops at the first value that is certainly negative. */
hl_verdict filtered_verdict(const double bernstein[HL_BERNSTEIN]);

/* Whether a face's values are certainly above `bound` by more than the rounding errors of any candidate on it, so that
   find_kept_roots has none below; false where that is not clear. No value on the face's edges may be below the bound: (B2). */
bool face_is_above(const double beta[HL_FACE_BERNSTEIN], double bound);

#endif
