/* Checks of other programs: the numbers of hl_check (docs/algorithm.md 9). */
#ifndef HL_CHECKS_H
#define HL_CHECKS_H

#include "scaling.h"

/* jacdet in the middle of the cube, in the units of the coefficients, and the columns of DF there, in those of the edge vectors. */
typedef struct middle_point {
  double jacdet, columns[3][3];
} middle_point;

middle_point middle_in_doubles(const edge_vectors *edges, const double bernstein[27]);

/* The least scaled Jacobian, det DF over the product of its columns' lengths, at the vertices and in the middle; det DF from
   the coefficients, times 2^exponent. */
double least_scaled_jacobian(const edge_vectors *edges, const double bernstein[27], const middle_point *middle,
                             int exponent);

/* That number by the rules of Verdict, the library of VTK: 1e30 where an edge or an axis is short beside the element. */
double scaled_jacobian_of_verdict(const double vertices[24], double least_scaled_jacobian);

/* Both take Bernstein coefficients, and answer in their units. */
double least_at_gauss_points(const double bernstein[27], int points_per_axis);
double subdivision_to_depth_4(const double bernstein[27]);

#endif
