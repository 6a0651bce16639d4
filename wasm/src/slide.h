/* Where a boundary point of a mesh may go: docs/repair.md (R15), (R16). */
#ifndef HL_SLIDE_H
#define HL_SLIDE_H

#include "mesh.h"

/* The limits of a boundary point, from the coordinates that were given; false if it has to stay. */
bool boundary_limits(const mesh *m, const double *given, const hl_untangling *wanted, uint32_t p, hl_limits *limits);

#endif
