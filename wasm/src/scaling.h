/* Powers of two: exact scaling of an element, axis by axis, so that all sizes are computed alike (docs/algorithm.md 2). */
#ifndef HL_SCALING_H
#define HL_SCALING_H

#include <stdbool.h>

/* mantissa * 2^exponent; the mantissa is of magnitude in [1/2, 1), or 0. */
typedef struct scaled_double {
  double mantissa;
  int exponent;
} scaled_double;

/* The twelve edge vectors; component r of each is its number times 2^axis_exponent[r], and on each axis the largest
   number is in [1/2, 1), or all are 0. */
typedef struct edge_vectors {
  double u[2][2][3]; /* u[j][k] = p_1jk - p_0jk */
  double v[2][2][3]; /* v[i][k] = p_i1k - p_i0k */
  double w[2][2][3]; /* w[i][j] = p_ij1 - p_ij0 */
  int axis_exponent[3];
} edge_vectors;

bool all_finite(const double *values, int count);

/* x * 2^exponent, exact whenever it is a normal double. For x != 0, |exponent| <= 4088. */
double times_power_of_two(double x, int exponent);

/* The e with |x| * 2^-e in [1/2, 1), for x != 0. */
int binary_exponent(double x);

/* x * 2^exponent is a normal double, or x is 0. */
bool is_normal_after_scaling(double x, int exponent);

/* x / 2^unit; what the doubles have no room for is the least or the greatest normal one of its sign. |unit| <= 8000. */
double in_normal_units(scaled_double x, int unit);

/* Multiplies 2^exponent into all the values if that is exact for every one; returns the exponent that is left. */
int scaled_back(double *values, int count, int exponent);

void scaled_edge_vectors(const double vertices[24], edge_vectors *edges);

/* The exponent of jacdet computed from scaled edge vectors. */
int jacdet_exponent(const edge_vectors *edges);

#endif
