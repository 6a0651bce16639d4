/* Batches with a given fast stage, for tests and benchmarks: every one gives the same. */
#ifndef HL_BATCH_H
#define HL_BATCH_H

#include "hexlens.h"
#include "lanes.h"

#include <stdbool.h>

/* Cells that went on from each stage to the next. */
typedef struct batch_stages {
  size_t after_lanes, after_doubles; /* not decided, or not minimal, in the lanes; left to integers */
} batch_stages;

/* Lists with one entry a cell, each of which may be null; `accepted_by` and `relative_minima` only together with minima. Of a cell that is
   unanswered the bytes are 0, the number NaN. */
typedef struct batch_hints {
  uint8_t *coincident;    /* 1 where two vertices or more are at one position */
  uint8_t *accepted_by;   /* of an invalid cell which of CORNER_CHECKS accept it, bit 1 << c; else 0 */
  float *relative_minima; /* within 2^-20, (L5); NaN where that is not certain */
  bool leaves_valid;      /* relative minima of invalid cells alone: NaN for the others */
  /* Least x, y and z, then the greatest, of what was there and of all cells, if these are answered; or null. */
  double *box;
} batch_hints;

/* hl_classify with these kernels, or one by one where they are null. `hints` and `stages` may be null. */
hl_status classify_with(const lane_kernels *kernels, const hl_cells *cells, hl_batch *batch, const batch_hints *hints,
                        batch_stages *stages);

/* All kernels that this machine runs, widest first, at most four; returns how many. */
int usable_lanes(const lane_kernels *list[4]);

#endif
