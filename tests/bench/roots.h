/* The paper's two variants, Roots and Roots+B, as it describes them: scalar, one element at a time, no error bounds. What the
   batches are measured against, and no part of the core. */
#ifndef BENCH_ROOTS_H
#define BENCH_ROOTS_H

#include <stdbool.h>

/* True if jacdet > 0 at every candidate; stops at the first that is not. */
bool roots_validity(const double vertices[24], bool with_bounds);

/* The least value at a candidate, and where. */
double roots_minimum(const double vertices[24], bool with_bounds, double minimizer[3]);

/* A plain loop's worth of arithmetic to compare with: the sum of jacdet at the corners and the edges' middles. */
double twenty_determinants(const double vertices[24]);

#endif
