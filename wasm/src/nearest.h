/* The point of some half-spaces that is nearest to 0, or the few of them that have no point in common: docs/repair.md (R8), (R9). */
#ifndef HL_NEAREST_H
#define HL_NEAREST_H

#include <stdbool.h>
#include <stddef.h>

/* Half-space i is x[i] z0 + y[i] z1 + w[i] z2 >= offset[i], of a normal of length 1; one without a normal is 0 >= offset[i]. */
typedef struct half_spaces {
  double *x, *y, *w, *offset;
  size_t count;
} half_spaces;

enum { MOST_SUPPORTS = 4 };

typedef enum nearest_kind { NEAREST_FOUND, NEAREST_NONE, NEAREST_OPEN } nearest_kind;

typedef struct nearest_point {
  nearest_kind kind; /* found; there is none; too many steps, which rounding alone can cause */
  double z[3];
  /* Where there is none: half-spaces whose normals, times the weights, cancel, while their offsets sum to more than 0. */
  int support_count;
  size_t supports[MOST_SUPPORTS];
  double weights[MOST_SUPPORTS];
} nearest_point;

/* Costs a few passes through the half-spaces. */
nearest_point find_nearest(const half_spaces *all);

#endif
