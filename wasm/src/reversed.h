/* Cells whose nodes are numbered the other way round: docs/repair.md 9. */
#ifndef HL_REVERSED_H
#define HL_REVERSED_H

#include "mesh.h"

/* As hl_reversed_cells; `volumes` and `queue` have one entry a cell. */
void find_reversed(const mesh *m, const double *coordinates, double *volumes, uint32_t *queue, uint8_t *reversed);

#endif
