#include "checks.h"
#include "bernstein.h"
#include "subdivision.h"
#include "topology.h"

#include <math.h>

/* A column of DF: its vector and its length, times 2^exponent. */
typedef struct column {
  double vector[3], length;
  int exponent;
} column;

/* A column from a vector in the axes' own scales; a length needs one, in which the largest
   component is in [1/2, 1). What underflows then is nothing beside it. */
static column column_of(const double vector[3], const int axis_exponent[3]) {
  column c = {.length = 0};
  bool is_zero = true;
  for (int r = 0; r < 3; ++r) {
    if (vector[r] == 0) continue;
    int exponent = binary_exponent(vector[r]) + axis_exponent[r];
    if (is_zero || exponent > c.exponent) c.exponent = exponent;
    is_zero = false;
  }
  if (is_zero) return c;
  for (int r = 0; r < 3; ++r) c.vector[r] = times_power_of_two(vector[r], axis_exponent[r] - c.exponent);
  c.length = __builtin_sqrt(dot(c.vector, c.vector));
  return c;
}

/* jacdet over the product of the lengths: of its sign, and not 0 however small unless jacdet is. It is at most 1 (Hadamard)
   unless a column is nothing but the rounding errors of the edges whose mean it is; then the size is what those columns
   give. 0 where a length is. */
static double scaled_jacobian(double jacdet, int exponent, const column *u, const column *v, const column *w) {
  const int least_exponent = -960, greatest_exponent = 3; /* beyond, the ratio is above 2^4 / 2 / 3^1.5 > 1 */
  double product = u->length * v->length * w->length, normal[3];
  if (jacdet == 0 || product == 0) return 0;
  int own = binary_exponent(jacdet), power = exponent + own - (u->exponent + v->exponent + w->exponent);
  if (power <= greatest_exponent) {
    double number = times_power_of_two(jacdet, -own) / product;
    double ratio = times_power_of_two(number, power < least_exponent ? least_exponent : power);
    if (ratio <= 1 && ratio >= -1) return ratio;
  }
  cross(u->vector, v->vector, normal);
  double size = fabs(dot(normal, w->vector) / product);
  if (size < 0x1p-960) size = 0x1p-960;
  return jacdet > 0 ? size : -size;
}

/* The value at the centre of the element: the mean of the coefficients with weights 1, 2, 1 on each axis. */
static double value_at_centre(const double bernstein[27]) {
  double sum = 0;
  for (int i = 0; i < 27; ++i) {
    const int ones = (axis_digit(i, 0) == 1) + (axis_digit(i, 1) == 1) + (axis_digit(i, 2) == 1);
    sum += bernstein[i] * (1 << ones);
  }
  return sum / 64;
}

static void mean_of(const double family[2][2][3], double mean[3]) {
  for (int r = 0; r < 3; ++r)
    mean[r] = 0.25 * ((family[0][0][r] + family[0][1][r]) + (family[1][0][r] + family[1][1][r]));
}

middle_point middle_in_doubles(const edge_vectors *edges, const double bernstein[27]) {
  middle_point middle = {.jacdet = value_at_centre(bernstein)};
  mean_of(edges->u, middle.columns[0]);
  mean_of(edges->v, middle.columns[1]);
  mean_of(edges->w, middle.columns[2]);
  return middle;
}

double least_scaled_jacobian(const edge_vectors *edges, const double bernstein[27], const middle_point *middle,
                             int exponent) {
  const int *e = edges->axis_exponent;
  column u[2][2], v[2][2], w[2][2], centre[3];
  for (int c = 0; c < 3; ++c) centre[c] = column_of(middle->columns[c], e);
  for (int m = 0; m < 2; ++m)
    for (int n = 0; n < 2; ++n) {
      u[m][n] = column_of(edges->u[m][n], e);
      v[m][n] = column_of(edges->v[m][n], e);
      w[m][n] = column_of(edges->w[m][n], e);
    }
  double least = scaled_jacobian(middle->jacdet, exponent, &centre[0], &centre[1], &centre[2]);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) {
        double jacdet = bernstein[bernstein_index(2 * i, 2 * j, 2 * k)];
        least = smaller(least, scaled_jacobian(jacdet, exponent, &u[j][k], &v[i][k], &w[i][j]));
      }
  return least;
}

/* Verdict takes lengths up to 10 epsilon as none, and returns 1e30 then: (S1) and (S2). */
#define VERDICT_LEAST 0x1.4p-49
#define VERDICT_GREATEST 1e30

/* The eight points about their mean, in units of the diagonal of their box; false where that has no size. */
static bool unit_points(const double vertices[24], double points[8][3]) {
  double mean[3], square = 0;
  for (int r = 0; r < 3; ++r) {
    double least = VERDICT_GREATEST, greatest = -VERDICT_GREATEST, sum = 0;
    for (int i = r; i < 24; i += 3) {
      least = smaller(least, vertices[i]);
      greatest = larger(greatest, vertices[i]);
      sum += vertices[i];
    }
    mean[r] = 0.125 * sum;
    square += (greatest - least) * (greatest - least);
  }
  const double diagonal = __builtin_sqrt(square);
  if (!(diagonal >= VERDICT_LEAST && diagonal < INFINITY)) return false;
  for (int i = 0; i < 24; ++i) points[i / 3][i % 3] = (vertices[i] - mean[i % 3]) / diagonal;
  return true;
}

/* The three sums of four edges, then the edges. */
double scaled_jacobian_of_verdict(const double vertices[24], double least_scaled_jacobian) {
  double points[8][3];
  if (!unit_points(vertices, points)) return VERDICT_GREATEST;
  for (int c = 0; c < 3 + 12; ++c) {
    double vector[3] = {0, 0, 0};
    for (int r = 0; r < 3; ++r) {
      if (c >= 3) vector[r] = points[edge_ends[c - 3][1]][r] - points[edge_ends[c - 3][0]][r];
      for (int p = 0; c < 3 && p < 8; ++p) vector[r] += vertex_reference[p][c] ? points[p][r] : -points[p][r];
    }
    if (dot(vector, vector) <= VERDICT_LEAST) return VERDICT_GREATEST;
  }
  return least_scaled_jacobian;
}

/* Bernstein polynomials of degree 2 at the points of the Gauss rules on [0,1], (1 -+ 1/sqrt(3))/2 and (1 -+ sqrt(3/5))/2. */
static const double gauss_basis[2][3][3] = {{{0.62200846792814621559, 0.33333333333333333333, 0.04465819873852045108},
                                             {0.04465819873852045108, 0.33333333333333333333, 0.62200846792814621559}},
                                            {{0.78729833462074168852, 0.2, 0.01270166537925831148},
                                             {0.25, 0.5, 0.25},
                                             {0.01270166537925831148, 0.2, 0.78729833462074168852}}};

/* The coefficients become values, one axis after the other. */
double least_at_gauss_points(const double bernstein[27], int points_per_axis) {
  const double (*basis)[3] = gauss_basis[points_per_axis - 2];
  double values[27];
  for (int i = 0; i < 27; ++i) values[i] = bernstein[i];
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 9; ++row) {
      int stride = axis_stride[axis];
      double *q = values + first_of_row(axis, row), q0 = q[0], q1 = q[stride], q2 = q[2 * stride];
      for (int p = 0; p < points_per_axis; ++p) q[p * stride] = basis[p][0] * q0 + basis[p][1] * q1 + basis[p][2] * q2;
      if (points_per_axis == 2) q[2 * stride] = q[0]; /* of two points the first stands in the third's place too */
    }
  return least_coefficient(values);
}

enum { GIVES_UP_PAST = 4 };

/* A part is accepted where all its coefficients are positive and rejected where a corner is not; else it is cut into eight, but
   not at the last depth. The number is the least bound of the accepted, or what rejected. */
static double subdivided(const double bernstein[27], int depth, int axis) {
  if (axis == 0) {
    double bound = least_coefficient(bernstein), corner = bernstein[0];
    if (bound > 0) return bound;
    for (int v = 1; v < 8; ++v) corner = smaller(corner, bernstein[vertex_index(v)]);
    if (!(corner > 0)) return corner;
    if (depth == GIVES_UP_PAST) return bound;
  }
  double lower[27], upper[27];
  halve_along(bernstein, axis, lower, upper);
  int next_depth = axis == 2 ? depth + 1 : depth, next_axis = axis == 2 ? 0 : axis + 1;
  double below = subdivided(lower, next_depth, next_axis);
  return below > 0 ? smaller(below, subdivided(upper, next_depth, next_axis)) : below;
}

double subdivision_to_depth_4(const double bernstein[27]) { return subdivided(bernstein, 0, 0); }
