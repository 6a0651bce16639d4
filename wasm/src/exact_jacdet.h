/* jacdet in integers: the doubles as given are integers over powers of two, one for each axis (docs/algorithm.md 7). */
#ifndef HL_EXACT_JACDET_H
#define HL_EXACT_JACDET_H

#include "hexlens.h"
#include "integer.h"

typedef struct exact_jacdet {
  integer bernstein[HL_BERNSTEIN]; /* four times the coefficients, over 2^exponent; that of the cube's centre is 0 */
  int exponent;
} exact_jacdet;

/* The sign of jacdet at a vertex. */
int exact_vertex_sign(workspace *w, const double vertices[HL_COORDINATES], int vertex);

void exact_bernstein(workspace *w, const double vertices[HL_COORDINATES], exact_jacdet *jacdet);

/* Sixteen times the coefficient of the cube's centre, over 2^exponent. */
integer exact_cube_centre(workspace *w, const exact_jacdet *jacdet);

/* DF in the middle of the cube, component r of column c at [c][r], each correctly rounded. */
void exact_middle_columns(workspace *w, const double vertices[HL_COORDINATES], scaled_double columns[3][3]);

/* The integral of jacdet, correctly rounded: mantissa * 2^exponent. */
scaled_double exact_volume(workspace *w, const double vertices[HL_COORDINATES]);

#endif
