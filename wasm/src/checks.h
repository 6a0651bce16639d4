/* What other programs would say of the same element: the numbers of hl_check (docs/algorithm.md 9). */
#ifndef HL_CHECKS_H
#define HL_CHECKS_H

#include "scaling.h"

/* The least scaled Jacobian, det DF over the product of its columns' lengths, at the vertices and the centre; det DF from
   the coefficients and the value at the centre, times 2^exponent. */
double least_scaled_jacobian(const edge_vectors *edges, const double bernstein[27], double centre, int exponent);

/* That number by the rules of Verdict, the library of VTK: 1e30 where an edge or an axis is short beside the element. */
double scaled_jacobian_of_verdict(const double vertices[24], double least_scaled_jacobian);

/* From Bernstein coefficients, in their units. */
double value_at_centre(const double bernstein[27]);
double least_at_gauss_points(const double bernstein[27], int points_per_axis);
double subdivision_to_depth_4(const double bernstein[27]);

#endif
