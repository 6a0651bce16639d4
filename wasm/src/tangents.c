#include "tangents.h"
#include "bernstein.h"
#include "error_bounds.h"
#include "topology.h"

/* (K4): what the coefficients' errors are multiplied by, and in u max|bernstein| what rounding adds. */
#define GROWTH 2.25
#define ROUNDING 32

/* The two ends of [0,1], and those of the pieces between. */
enum { MAX_ENDS = MAX_TANGENTS + 1 };

/* The point where two neighbouring tangents, at s and t, meet; or, of one tangent alone, what its
   value at an end is below the quadratic's there, as a part of a. */
typedef struct piece_end {
  double s, t, part_of_a;
} piece_end;

static int ends_of_pieces(int tangents, piece_end ends[MAX_ENDS]) {
  int count = 0;
  ends[count++] = (piece_end){0, 0, 0};
  ends[count++] = (piece_end){1, 1, 0};
  if (tangents == 1) { /* (K2) */
    ends[count++] = (piece_end){0, 0, 0.25};
    ends[count++] = (piece_end){1, 1, 0.25};
  }
  for (int i = 1; i < tangents; ++i)
    ends[count++] = (piece_end){(i - 1.0) / (tangents - 1), (double)i / (tangents - 1), 0};
  return count;
}

HL_INLINE double between(double p, double q, double t) { return p + t * (q - p); }

/* (K1): the polar form at s and t is the value at (s + t)/2 of both tangents; the first two pieces' ends are those of [0,1]. Of the
   coefficients q[0], q[stride], q[2 * stride]. */
HL_INLINE double value_below(const piece_end *at, const double *q, int stride) {
  const double q0 = q[0], q1 = q[stride], q2 = q[2 * stride];
  if (at->s != at->t) return between(between(q0, q1, at->s), between(q1, q2, at->s), at->t);
  const double end = at->s == 0 ? q0 : q2;
  return at->part_of_a == 0 ? end : end - at->part_of_a * ((q0 - q1) + (q2 - q1));
}

/* (9) where the quadratic is lower inside. */
static double least_of_quadratic(const double q[3], double least) {
  least = smaller(least, smaller(q[0], q[2]));
  if (!(q[1] < least && q[1] < q[0] && q[1] < q[2])) return least;
  const double r = (q[0] - q[1]) / ((q[0] - q[1]) + (q[2] - q[1]));
  return smaller(least, quadratic_at(q[0], q[1], q[2], r));
}

/* The least of the quadratics that tangents leave of a plane, in one variable by `stride`. */
static double least_on_plane(const double plane[9], int stride, const piece_end *ends, int count, double least) {
  for (int n = 0; n < count; ++n) {
    double q[3];
    for (int k = 0; k < 3; ++k) q[k] = value_below(&ends[n], plane + (4 - stride) * k, stride);
    least = least_of_quadratic(q, least);
  }
  return least;
}

double tangent_bound(const double bernstein[27], double error, int tangents) {
  piece_end ends[MAX_ENDS];
  const int count = ends_of_pieces(tangents, ends);
  double bounds[3]; /* by the variable that has no tangents */
  for (int axis = 0; axis < 3; ++axis) bounds[axis] = bernstein[0];
  for (int m = 0; m < count; ++m) {
    double plane[9]; /* a piece's end in xi, then in eta */
    for (int row = 0; row < 9; ++row)
      plane[row] = value_below(&ends[m], bernstein + first_of_row(0, row), axis_stride[0]);
    bounds[1] = least_on_plane(plane, 1, ends, count, bounds[1]);
    bounds[2] = least_on_plane(plane, 3, ends, count, bounds[2]);
    for (int row = 0; row < 9; ++row)
      plane[row] = value_below(&ends[m], bernstein + first_of_row(1, row), axis_stride[1]);
    bounds[0] = least_on_plane(plane, 1, ends, count, bounds[0]);
  }
  const double bound = larger(larger(bounds[0], bounds[1]), bounds[2]);
  const double off = GROWTH * error + ROUNDING * UNIT_ROUNDOFF * greatest_magnitude(bernstein, 27);
  return bound > off ? bound : smaller(bound, 0);
}
