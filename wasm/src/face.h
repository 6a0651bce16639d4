/* One face: the quartic P and the interior candidates at its roots (docs/algorithm.md 4). */
#ifndef HL_FACE_H
#define HL_FACE_H

#include "hexlens.h"

typedef struct face_solution {
  double quartic[HL_QUARTIC];
  bool quartic_is_zero;
  int root_count;
  hl_face_root roots[HL_MAX_ROOTS];
  double values[HL_MAX_ROOTS]; /* f(s*, t); meaningful for the kept ones */
} face_solution;

/* Solve the face with Bernstein coefficients beta[3*i + j], i in s, j in t, in scaled units. */
void solve_face(const double beta[HL_FACE_BERNSTEIN], face_solution *solution);

#endif
