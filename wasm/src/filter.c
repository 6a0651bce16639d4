/* Certain verdicts in doubles: every comparison with zero is one with the error bound of what is compared,
   docs/algorithm.md (8) and (F1) to (F3). */
#include "filter.h"
#include "bernstein.h"
#include "candidates.h"
#include "face.h"

/* In scaled units, (8) and (F1): a corner, a value on an edge, a coefficient of a face, a value on a face. */
#define CORNER_ERROR (49 * UNIT_ROUNDOFF)
#define EDGE_ERROR (96 * UNIT_ROUNDOFF)
#define FACE_BERNSTEIN_ERROR (215 * UNIT_ROUNDOFF)
#define FACE_ERROR (448 * UNIT_ROUNDOFF)

/* Halvings of [0,1] in t before a face is left to exact arithmetic. */
#define MAX_HALVINGS 12

typedef struct certificate {
  double b[3], n[3], d[5];
} certificate;

typedef struct certificate_error {
  double b, d;
} certificate_error;

static bool all_above(const double *values, int count, double bound) {
  for (int i = 0; i < count; ++i)
    if (!(values[i] > bound)) return false;
  return true;
}

static bool all_below(const double *values, int count, double bound) {
  for (int i = 0; i < count; ++i)
    if (!(values[i] < bound)) return false;
  return true;
}

/* The coefficients on [0,1/2] and on [1/2,1] by de Casteljau's scheme. */
static void halve(const double *p, int degree, double *lower, double *upper) {
  for (int i = 0; i <= degree; ++i) upper[i] = p[i];
  lower[0] = upper[0];
  for (int n = degree; n > 0; --n) {
    for (int i = 0; i < n; ++i) upper[i] = 0.5 * (upper[i] + upper[i + 1]);
    lower[degree - n + 1] = upper[0];
  }
}

/* Where B >= 0 or N <= 0 or D > 0 the parabola in s has its least value on an edge or above zero. */
static bool parabolas_are_positive(const certificate *c, certificate_error error, int halvings) {
  if (all_above(c->b, 3, error.b) || all_below(c->n, 3, -error.b) || all_above(c->d, 5, error.d)) return true;
  if (halvings == 0) return false;
  certificate lower, upper;
  halve(c->b, 2, lower.b, upper.b);
  halve(c->n, 2, lower.n, upper.n);
  halve(c->d, 4, lower.d, upper.d);
  return parabolas_are_positive(&lower, error, halvings - 1) && parabolas_are_positive(&upper, error, halvings - 1);
}

/* For a face whose edges are certainly positive. */
static bool face_is_positive(const double beta[9]) {
  if (all_above(beta, HL_FACE_BERNSTEIN, FACE_BERNSTEIN_ERROR)) return true;
  parabolas f;
  parabolas_in_s(beta, &f);
  certificate c = {.b = {f.b[0], f.b[1], f.b[2]}, .n = {f.n[0], f.n[1], f.n[2]}};
  quarter_discriminant(&f, c.d);
  double a = greatest_magnitude(f.a, 2), b = greatest_magnitude(f.b, 3), k = greatest_magnitude(f.c, 3);
  const double u = UNIT_ROUNDOFF;
  certificate_error error = {.b = 1400 * u,
                             .d = u * (1 + 215 * a + 1004 * k + 932 * b + 64 * (a * k + b * b))}; /* (F3) */
  return parabolas_are_positive(&c, error, MAX_HALVINGS);
}

/* In parts of the largest coefficient or its square: far above every rounding error, far below what matters, (B2). */
#define CLEARANCE 0x1p-34
#define SKIP_HALVINGS 3

static void exchange_s_and_t(const double beta[9], double out[9]) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out[3 * i + j] = beta[3 * j + i];
}

static certificate certificate_above(const double beta[9], double bound) {
  parabolas f;
  certificate c;
  double above[9];
  for (int i = 0; i < HL_FACE_BERNSTEIN; ++i) above[i] = beta[i] - bound;
  parabolas_in_s(above, &f);
  for (int j = 0; j < 3; ++j) {
    c.b[j] = f.b[j];
    c.n[j] = f.n[j];
  }
  quarter_discriminant(&f, c.d);
  return c;
}

bool face_is_above(const double beta[9], double bound) {
  double size = greatest_magnitude(beta, HL_FACE_BERNSTEIN), exchanged[9];
  if (size < greatest_magnitude(&bound, 1)) size = greatest_magnitude(&bound, 1);
  certificate_error error = {.b = CLEARANCE * size, .d = CLEARANCE * size * size};
  exchange_s_and_t(beta, exchanged);
  certificate in_s = certificate_above(beta, bound), in_t = certificate_above(exchanged, bound);
  return parabolas_are_positive(&in_s, error, 0) || parabolas_are_positive(&in_t, error, 0) ||
      parabolas_are_positive(&in_s, error, SKIP_HALVINGS) || parabolas_are_positive(&in_t, error, SKIP_HALVINGS);
}

static bool has_negative_candidate(const double beta[9]) {
  face_solution solution;
  find_kept_roots(beta, &solution);
  for (int r = 0; r < solution.root_count; ++r)
    if (solution.values[r] < -FACE_ERROR) return true;
  return false;
}

hl_verdict filtered_verdict(const double bernstein[27]) {
  bool certain = true;
  for (int v = 0; v < HL_VERTICES; ++v) {
    double value = vertex_candidate(bernstein, v).value;
    if (value < -CORNER_ERROR) return HL_INVALID;
    if (!(value > EDGE_ERROR)) certain = false; /* an edge's middle may be as low as its ends, less its own error */
  }
  for (int e = 0; e < HL_EDGES; ++e) {
    hl_candidate candidate;
    if (!edge_candidate(bernstein, e, &candidate)) continue;
    if (candidate.value < -EDGE_ERROR) return HL_INVALID;
    if (!(candidate.value > EDGE_ERROR)) certain = false;
  }
  for (int f = 0; f < HL_FACES; ++f) {
    double beta[HL_FACE_BERNSTEIN];
    face_bernstein(bernstein, f, beta);
    if (certain && face_is_positive(beta)) continue;
    if (has_negative_candidate(beta)) return HL_INVALID;
    certain = false;
  }
  return certain ? HL_VALID : HL_UNDECIDED;
}
