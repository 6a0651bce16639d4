/* One face: the quartic P and the interior candidates at its roots (docs/algorithm.md 4). */
#ifndef HL_FACE_H
#define HL_FACE_H

#include "hexlens.h"

/* f = a s^2 + 2B s + c as functions of t: a by its two ends, B and c by three Bernstein coefficients; N = a + B, so that
   s* = -B/a = -B/(N - B). */
typedef struct parabolas {
  double a[2], b[3], n[3], c[3];
} parabolas;

void parabolas_in_s(const double beta[HL_FACE_BERNSTEIN], parabolas *f);

typedef struct face_solution {
  int root_count;
  hl_face_root roots[HL_MAX_ROOTS];
  double values[HL_MAX_ROOTS]; /* f(s*, t) of the kept ones */
  double quartic[HL_QUARTIC];  /* times 2^quartic_exponent */
  int quartic_exponent;
  bool quartic_is_zero;
} face_solution;

/* Both take a face's Bernstein coefficients beta[3*i + j], i in s, j in t, in scaled units. */

/* The roots that are kept, with their values, and nothing else: all that the minimum needs. */
void find_kept_roots(const double beta[HL_FACE_BERNSTEIN], face_solution *solution);

/* All of it, the roots that are dropped among it. */
void solve_face(const double beta[HL_FACE_BERNSTEIN], face_solution *solution);

#endif
