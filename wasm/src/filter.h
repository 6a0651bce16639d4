/* The certified filter: valid, invalid, or left open by doubles, from the Bernstein coefficients and their error bounds
   (docs/algorithm.md 7). */
#ifndef HL_FILTER_H
#define HL_FILTER_H

#include "hexlens.h"

/* True if doubles are certain of the verdict, from coefficients in scaled units. Stops at the first
   value that is certainly negative. */
bool is_settled_by_filter(const double bernstein[HL_BERNSTEIN], hl_verdict *verdict);

/* True if doubles leave a corner open and none is certainly negative: then integers say sooner what
   that corner is than the filter what edges and faces are. */
bool has_open_corner(const double bernstein[HL_BERNSTEIN]);

/* True if a face can have a value below `bound`, given that its edges have none: not if its
   Bernstein bound or the criterion of the filter, for f - bound, says no. What answers for many
   elements asks this before it solves the face, what answers for one before it takes a candidate of
   it; so both have the same minimizer, (B2). */
bool face_can_be_lower(const double beta[HL_FACE_BERNSTEIN], double bound);

#endif
