/* One face in integers: its sign, and its minimum where it is below its edges (docs/algorithm.md 7). */
#ifndef HL_EXACT_FACE_H
#define HL_EXACT_FACE_H

#include "hexlens.h"
#include "integer.h"

/* Bernstein coefficients, [i][j], i in s and j in t, in any unit. */
typedef struct exact_face {
  integer beta[3][3];
} exact_face;

/* The sign of a face that has no negative value on its edges: -1 if it has one inside; else, if the
   edges are positive, 0 if it has a zero and 1 if it is positive. */
int exact_face_sign(workspace *w, const exact_face *face);

/* The least value so far, numerator / denominator with denominator > 0, and where a face has it. */
typedef struct least_value {
  integer numerator, denominator;
  double s, t;
} least_value;

/* Lowers `least` to the face's minimum, to 2^-57 of itself, if that is lower by as much; returns whether it did. No face that is 0 at
   its minimum may come here, nor a `least` of 0 but for a face with negative values. The edges have no value below `least`; `roots`
   are values of t in (0,1) near which the minimum may be. */
bool exact_face_lowers(workspace *w, const exact_face *face, const double *roots, int root_count, least_value *least);

/* The point where a face, positive elsewhere, touches zero: within 2^-64 of its coefficients. */
void exact_face_touch(workspace *w, const exact_face *face, const double *roots, int root_count, least_value *least);

/* The double nearest to numerator / denominator * 2^exponent among those between 0 and 1, as that is, and neither of them. */
double inside_unit_interval(workspace *w, integer numerator, integer denominator, int exponent);

#endif
