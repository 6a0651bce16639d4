/* Polynomials with integer coefficients and how many of their positive roots there are: docs/algorithm.md (X2). */
#ifndef HL_STURM_H
#define HL_STURM_H

#include "integer.h"

/* c[i] is that of x^i; the degree of 0 is -1. With t = x / (1 + x) a Bernstein form on (0,1) is, up to a positive factor, the
   polynomial of its coefficients times binomials on (0, infinity), where signs near the ends are those of outer coefficients. */
enum { MOST_COEFFICIENTS = 6 };
typedef struct polynomial {
  integer c[MOST_COEFFICIENTS];
  int degree;
} polynomial;

/* Leading coefficients that are 0 do not count. */
void lower_degree(polynomial *p);

/* The signs of a polynomial that is not 0 near both ends of (0, infinity). */
int sign_at_zero(const polynomial *p);
int sign_at_infinity(const polynomial *p);

/* The number of different roots of p in (0, infinity) at which g < 0, by Sturm's theorem and
   Sylvester's; p and g are not 0, and have no common root there. `common` becomes the common
   divisor of p and its derivative. */
int roots_with_negative(workspace *w, const polynomial *p, const polynomial *g, polynomial *common);

#endif
