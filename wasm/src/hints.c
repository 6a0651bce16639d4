/* Hints about cells, each a cheap test that errs on one side. */
#include "hints.h"
#include "bernstein.h"
#include "topology.h"

#include <float.h>
#include <math.h>

static bool are_one(const double *p, int a, int b) {
  return p[3 * a] == p[3 * b] && p[3 * a + 1] == p[3 * b + 1] && p[3 * a + 2] == p[3 * b + 2];
}

/* A valid element has only the four diagonals through the middle to look at: where the ends of an edge or of a face's diagonal coincide, two
   columns of the jacobian at a vertex are dependent, and jacdet is 0 there. */
bool has_coincident_vertices(const double vertices[24], bool is_valid) {
  if (is_valid)
    return are_one(vertices, 0, 6) || are_one(vertices, 1, 7) || are_one(vertices, 2, 4) || are_one(vertices, 3, 5);
  for (int a = 0; a < HL_VERTICES; ++a)
    for (int b = a + 1; b < HL_VERTICES; ++b)
      if (are_one(vertices, a, b)) return true;
  return false;
}

/* VTK accepts an element whose box has a diagonal below 2^-48, and one of which an edge, or the sum of the four edges along an axis, is
   shorter than 2^-24 of the diagonal, (S1) and (S2), as it computes it: from points about their mean in units of the diagonal, each off by
   up to 4u of the greatest coordinate over the diagonal, a sum of eight by less than 2^-24 if that is below 2^24. So it may accept below
   these bounds. */
#define SMALL 0x1p-90
#define SHORT 0x1p-40
#define FAR 0x1p-48

static double square_of(const double v[3]) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

static bool has_short_vector(const double vertices[24]) {
  double square = 0, greatest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double least = vertices[axis], most = vertices[axis];
    for (int i = axis + 3; i < 24; i += 3) {
      least = smaller(least, vertices[i]);
      most = larger(most, vertices[i]);
    }
    square += (most - least) * (most - least);
    greatest = larger(greatest, larger(most, -least));
  }
  if (!(square > SMALL && square > FAR * greatest * greatest && square < INFINITY)) return true;
  const double bound = SHORT * square;
  double sums[3][3] = {{0}};
  for (int e = 0; e < HL_EDGES; ++e) {
    const double *from = vertices + 3 * edge_ends[e][0], *to = vertices + 3 * edge_ends[e][1];
    const double edge[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    if (square_of(edge) <= bound) return true;
    for (int r = 0; r < 3; ++r) sums[edge_table[e].axis][r] += edge[r];
  }
  return square_of(sums[0]) <= bound || square_of(sums[1]) <= bound || square_of(sums[2]) <= bound;
}

bool may_be_accepted(const double vertices[24], double corner_minimum) {
  return corner_minimum > 0 || has_short_vector(vertices);
}

/* (L4) */
#define VOLUME_ERROR 0x1p-48
/* Products of three coordinates from there to there lose no bits. */
#define LEAST_SIZE 0x1p-300
#define GREATEST_SIZE 0x1p300
/* (L5) */
#define CERTAIN 0x1p-22

float relative_minimum_about(double minimum, double twelvefold, double size) {
  if (minimum == 0) return 0;
  if (!(size > LEAST_SIZE && size < GREATEST_SIZE)) return NAN;
  if (!(VOLUME_ERROR * size <= CERTAIN * fabs(twelvefold))) return NAN;
  const double about = 12 * minimum / fabs(twelvefold), magnitude = fabs(about);
  return magnitude >= FLT_MIN && magnitude <= FLT_MAX ? (float)about : NAN;
}
