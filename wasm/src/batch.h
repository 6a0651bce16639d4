/* Batches with a given fast stage, for tests and benchmarks: every one gives the same. */
#ifndef HL_BATCH_H
#define HL_BATCH_H

#include "hexlens.h"
#include "lanes.h"

/* Cells that went on from each stage to the next. */
typedef struct batch_stages {
  size_t after_lanes, after_doubles; /* not decided, or not minimal, in the lanes; left to integers */
} batch_stages;

/* hl_classify with these kernels, or one by one where they are null. `stages` may be null. */
hl_status classify_with(const lane_kernels *kernels, const hl_cells *cells, hl_batch *batch, batch_stages *stages);

/* All kernels that this machine runs, widest first, at most four; returns how many. */
int usable_lanes(const lane_kernels *list[4]);

#endif
