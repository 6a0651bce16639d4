/* Integers decide what doubles leave open: verdict, boundary minimum and report (docs/algorithm.md
   7). Every element gets an answer. The memory is on the stack: 20 kB for ordinary verdicts, 160 kB
   for some minima, 2.6 MB where coordinates span the exponents of the doubles. */
#ifndef HL_EXACT_H
#define HL_EXACT_H

#include "hexlens.h"
#include "scaling.h"

/* The cost of an answer, for benchmarks. */
typedef struct exact_cost {
  uint32_t multiplications; /* of integers */
  uint64_t products;        /* of their limbs */
} exact_cost;

/* True if jacdet is 0 at a vertex at sight, since two ends of an edge or of a face's diagonal
   coincide: the two columns of DF that lead there are parallel, or one is 0. */
bool is_zero_at_sight(const double vertices[HL_COORDINATES]);

/* The verdict; `bernstein` are the coefficients in doubles and scaled units. `cost` may be null. */
hl_verdict exact_verdict(const double vertices[HL_COORDINATES], const double bernstein[HL_BERNSTEIN], exact_cost *cost);

/* The boundary minimum: rounded to the nearest double where a vertex or an edge has it, and off by 2^-57 more on a face; of exact
   sign. The position of the minimizer is left to the caller, and so is its value. */
typedef struct exact_minimum {
  hl_candidate minimizer;
  scaled_double minimum, corner_minimum;
} exact_minimum;

void find_exact_minimum(const double vertices[HL_COORDINATES], exact_minimum *minimum, exact_cost *cost);

/* The numbers of a report that doubles would not give in full, each rounded once. */
typedef struct exact_values {
  exact_minimum boundary;
  double bernstein
      [HL_BERNSTEIN]; /* times 2^unit, the largest of magnitude in [1/2, 1), each off by at most `error` and of exact sign */
  double error;
  int unit;
  scaled_double coefficients[HL_BERNSTEIN];                               /* the same, of any size */
  hl_candidate vertex_candidates[HL_VERTICES], edge_candidates[HL_EDGES]; /* without values and positions */
  int edge_count;
  scaled_double vertices[HL_VERTICES], on_edges[HL_EDGES]; /* their values */
  scaled_double edge_minimum, bernstein_minimum, gauss_2, gauss_3;
  scaled_double centre, columns[3][3]; /* jacdet and DF in the middle of the cube, component r of column c at [c][r] */
} exact_values;

void find_exact_values(const double vertices[HL_COORDINATES], exact_values *values, exact_cost *cost);

/* True if jacdet is 0 everywhere. */
bool is_collapsed(const double vertices[HL_COORDINATES]);

/* The integral of jacdet, rounded to the nearest double. */
scaled_double find_exact_volume(const double vertices[HL_COORDINATES]);

#endif
