/* Exact powers of two by the bits of the doubles; edge vectors scaled axis by axis: docs/algorithm.md (2). */
#include "scaling.h"
#include "topology.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { EXPONENT_BIAS = 1023, LEAST_NORMAL = -1022, GREATEST = 1023 };

HL_INLINE uint64_t bits_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

HL_INLINE double power_of_two(int exponent) { /* LEAST_NORMAL <= exponent <= GREATEST */
  uint64_t bits = (uint64_t)(exponent + EXPONENT_BIAS) << 52;
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

/* floor(log2 |x|) for x != 0. */
static int exponent_of(double x) {
  int biased = (int)(bits_of(x) >> 52 & 0x7ff);
  if (biased > 0) return biased - EXPONENT_BIAS;
  return exponent_of(x * power_of_two(64)) - 64; /* subnormal */
}

int binary_exponent(double x) { return exponent_of(x) + 1; }

bool all_finite(const double *values, int count) {
  for (int i = 0; i < count; ++i)
    if ((bits_of(values[i]) >> 52 & 0x7ff) == 0x7ff) return false;
  return true;
}

bool is_normal_after_scaling(double x, int exponent) {
  if (x == 0) return true;
  int e = exponent_of(x) + exponent;
  return e >= LEAST_NORMAL && e <= GREATEST;
}

double times_power_of_two(double x, int exponent) {
  if (exponent >= LEAST_NORMAL && exponent <= GREATEST) return x * power_of_two(exponent);
  if (x == 0) return x;
  /* Quarters keep each factor among the doubles; between x and a normal result all is exact. */
  int quarter = exponent / 4;
  double factor = power_of_two(quarter);
  return x * factor * factor * factor * power_of_two(exponent - 3 * quarter);
}

double in_normal_units(scaled_double x, int unit) {
  const int power = x.exponent - unit;
  if (x.mantissa == 0) return 0;
  if (power > LEAST_NORMAL && power <= GREATEST + 1) return times_power_of_two(x.mantissa, power);
  const double nearest = power > LEAST_NORMAL ? DBL_MAX : DBL_MIN;
  return x.mantissa < 0 ? -nearest : nearest;
}

int scaled_back(double *values, int count, int exponent) {
  for (int i = 0; i < count; ++i)
    if (!is_normal_after_scaling(values[i], exponent)) return exponent;
  for (int i = 0; i < count; ++i) values[i] = times_power_of_two(values[i], exponent);
  return 0;
}

static void subtract_vertices(const double p[8][3], int axis, edge_vectors *edges) {
  for (int m = 0; m < 2; ++m)
    for (int n = 0; n < 2; ++n) {
      edges->u[m][n][axis] = p[vertex_at[1][m][n]][axis] - p[vertex_at[0][m][n]][axis];
      edges->v[m][n][axis] = p[vertex_at[m][1][n]][axis] - p[vertex_at[m][0][n]][axis];
      edges->w[m][n][axis] = p[vertex_at[m][n][1]][axis] - p[vertex_at[m][n][0]][axis];
    }
}

HL_INLINE double larger_magnitude(double greatest, double x) { return fabs(x) > greatest ? fabs(x) : greatest; }

void scaled_edge_vectors(const double vertices[24], edge_vectors *edges) {
  double p[8][3];
  for (int axis = 0; axis < 3; ++axis) {
    double extent = 0;
    for (int i = 0; i < 8; ++i) extent = larger_magnitude(extent, vertices[3 * i + axis]);
    /* A difference of coordinates of 2^1023 and more may overflow: halve them first. */
    int halvings = extent >= power_of_two(GREATEST) ? 1 : 0;
    for (int i = 0; i < 8; ++i) p[i][axis] = halvings ? 0.5 * vertices[3 * i + axis] : vertices[3 * i + axis];
    subtract_vertices((const double (*)[3])p, axis, edges);

    double *const families[3] = {&edges->u[0][0][axis], &edges->v[0][0][axis], &edges->w[0][0][axis]};
    double greatest = 0;
    for (int f = 0; f < 3; ++f)
      for (int e = 0; e < 4; ++e) greatest = larger_magnitude(greatest, families[f][3 * e]);
    int exponent = greatest > 0 ? binary_exponent(greatest) : 0;
    for (int f = 0; f < 3; ++f)
      for (int e = 0; e < 4; ++e) families[f][3 * e] = times_power_of_two(families[f][3 * e], -exponent);
    edges->axis_exponent[axis] = greatest > 0 ? exponent + halvings : 0;
  }
}

int jacdet_exponent(const edge_vectors *edges) {
  return edges->axis_exponent[0] + edges->axis_exponent[1] + edges->axis_exponent[2];
}
