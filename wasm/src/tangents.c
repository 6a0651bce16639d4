#include "tangents.h"
#include "bernstein.h"
#include "topology.h"

/* (K4): what the coefficients' errors are multiplied by, and in u max|bernstein| what rounding adds. */
#define GROWTH 2.25
#define ROUNDING 32

/* The two ends of [0,1], and those of the pieces between: at most MAX_TANGENTS + 1 but for one tangent, which has two more. */
enum { MAX_ENDS = MAX_TANGENTS + 1 };

/* A value of a quadratic, or of the tangents below it, from its Bernstein coefficients. */
typedef struct weights {
  double of[3];
} weights;

/* (K1): the value at (s + t)/2 of the tangent at s, and of that at t. */
static weights of_tangents(double s, double t) {
  return (weights){{(1 - s) * (1 - t), s * (1 - t) + t * (1 - s), s * t}};
}

static int ends_of_pieces(int tangents, weights ends[MAX_ENDS]) {
  int count = 0;
  ends[count++] = of_tangents(0, 0);
  ends[count++] = of_tangents(1, 1);
  if (tangents == 1) { /* at 1/2, its values at 0 and 1 */
    ends[count++] = of_tangents(-0.5, 0.5);
    ends[count++] = of_tangents(0.5, 1.5);
  }
  for (int i = 1; i < tangents; ++i) ends[count++] = of_tangents((i - 1.0) / (tangents - 1), (double)i / (tangents - 1));
  return count;
}

static double weighted(const weights *w, const double *q, int stride) {
  return w->of[0] * q[0] + w->of[1] * q[stride] + w->of[2] * q[2 * stride];
}

/* (9) where the quadratic is lower inside. */
static double least_of_quadratic(const double q[3], double least) {
  least = smaller(least, smaller(q[0], q[2]));
  if (!(q[1] < least && q[1] < q[0] && q[1] < q[2])) return least;
  return smaller(least, quadratic_at(q[0], q[1], q[2], (q[0] - q[1]) / ((q[0] - q[1]) + (q[2] - q[1]))));
}

/* Of all quadratics in the variable `last` that the tangents in the two others leave. */
static double bound_along(const double bernstein[27], int last, const weights *ends, int count) {
  const int first = axis_stride[last == 0 ? 1 : 0], second = axis_stride[last == 2 ? 1 : 2], along = axis_stride[last];
  double least = bernstein[0];
  for (int m = 0; m < count; ++m) {
    double plane[3][3];
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) plane[i][k] = weighted(&ends[m], bernstein + i * second + k * along, first);
    for (int n = 0; n < count; ++n) {
      double q[3];
      for (int k = 0; k < 3; ++k) q[k] = weighted(&ends[n], &plane[0][k], 3);
      least = least_of_quadratic(q, least);
    }
  }
  return least;
}

double tangent_bound(const double bernstein[27], double error, int tangents) {
  weights ends[MAX_ENDS];
  const int count = ends_of_pieces(tangents, ends);
  double bound = bound_along(bernstein, 0, ends, count);
  for (int last = 1; last < 3; ++last) bound = larger(bound, bound_along(bernstein, last, ends, count));
  const double off = GROWTH * error + ROUNDING * UNIT_ROUNDOFF * greatest_magnitude(bernstein, 27);
  return bound > off ? bound : smaller(bound, 0);
}
