/* F and DF at a reference point. */
#ifndef HL_MAP_H
#define HL_MAP_H

#include "hexlens.h"
#include "scaling.h"

/* F(point) for a point of [0,1]^3; never outside the bounding box of the vertices. */
void map_point(const double vertices[24], const double point[3], double position[3]);

/* The candidate's position, map_point's. */
void map_candidate(const double vertices[24], hl_candidate *candidate);

/* dF/dxi, dF/deta, dF/dzeta in the scaled units of the edge vectors. */
void jacobian_columns(const edge_vectors *edges, const double point[3], double columns[3][3]);

#endif
