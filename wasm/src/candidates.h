/* The candidates of Algorithm 1, one by one. Positions are left to the caller. */
#ifndef HL_CANDIDATES_H
#define HL_CANDIDATES_H

#include "face.h"
#include "hexlens.h"

hl_candidate vertex_candidate(const double bernstein[HL_BERNSTEIN], int vertex);

/* The vertex of an upward parabola strictly inside the edge: its middle coefficient is the least of the three, (9). False, and
   nothing is written, if there is none or its value is not below `bound`, which may be infinite. */
bool edge_candidate(const double bernstein[HL_BERNSTEIN], int edge, double bound, hl_candidate *candidate);

/* The candidate of a root that was kept. */
hl_candidate face_candidate(int face, const face_solution *solution, int root);

#endif
