/* Untangling step by step, for those who cannot be called back: docs/repair.md 7. */
#ifndef HL_UNTANGLE_H
#define HL_UNTANGLE_H

#include "hexlens.h"

typedef struct untangling untangling;

/* As hl_untangle begins; the state lies in `memory`. `started` is null unless the status is HL_OK. */
hl_status begin_untangling(const hl_cells *cells, const hl_untangling *wanted, void *memory, size_t room,
                           double *points, untangling **started);

/* Looks at the next piece of stars, and asks `proceed` before. False when there is nothing more to do. */
bool step_untangling(untangling *u);

/* What has been done so far, without the distances of moves. */
const hl_untangled *result_so_far(const untangling *u);

/* Measures the moves; `held`, if it is not null, gets 1 for each point that may move and has a cell below the margin, else 0. */
void end_untangling(untangling *u, uint8_t *held, hl_untangled *result);

#endif
