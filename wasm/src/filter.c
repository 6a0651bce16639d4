/* Certain verdicts in doubles: every comparison with zero is one with the error bound of what is compared,
   docs/algorithm.md (8) and (F1) to (F3). */
#include "filter.h"
#include "bernstein.h"
#include "candidates.h"
#include "error_bounds.h"
#include "face.h"
#include "topology.h"

#include <math.h>

typedef struct certificate {
  double b[3], n[3], d[5];
} certificate;

typedef struct certificate_error {
  double b, d;
} certificate_error;

static bool all_above(const double *values, int count, double bound) {
  double least = values[0];
  for (int i = 1; i < count; ++i) least = smaller(least, values[i]);
  return least > bound;
}

static bool all_below(const double *values, int count, double bound) {
  double greatest = values[0];
  for (int i = 1; i < count; ++i) greatest = larger(greatest, values[i]);
  return greatest < bound;
}

/* ac - B^2 = D/4 in Bernstein form: where B < 0 < N the parabola's least value is this over a. */
static void quarter_discriminant(const parabolas *f, double d[HL_QUARTIC]) {
  const double *a = f->a, *b = f->b, *c = f->c;
  /* The outer coefficients of ac, degree 3, and three times the inner ones. */
  const double first = a[0] * c[0], second = 2 * a[0] * c[1] + a[1] * c[0], third = a[0] * c[2] + 2 * a[1] * c[1],
               last = a[1] * c[2];
  d[0] = first - b[0] * b[0];
  d[1] = 0.25 * (first + second) - b[0] * b[1];
  d[2] = (0.5 * (second + third) - (2 * b[1] * b[1] + b[0] * b[2])) / 3;
  d[3] = 0.25 * (third + last) - b[1] * b[2];
  d[4] = last - b[2] * b[2];
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

/* 1: where B >= 0 or N <= 0 or D > 0 the parabola in s has its least value on an edge or above zero, and that is so everywhere.
   -1: at a point in the middle B < 0 < N and D < 0, the parabola's vertex is inside and below zero. 0: neither is clear. */
static int sign_of_parabolas(const certificate *c, certificate_error error, int halvings) {
  if (all_above(c->b, 3, error.b) || all_below(c->n, 3, -error.b) || all_above(c->d, 5, error.d)) return 1;
  if (halvings == 0) return 0;
  certificate lower, upper;
  halve(c->b, 2, lower.b, upper.b);
  halve(c->n, 2, lower.n, upper.n);
  halve(c->d, 4, lower.d, upper.d);
  if (upper.b[0] < -error.b && upper.n[0] > error.b && upper.d[0] < -error.d) return -1;
  int sign = sign_of_parabolas(&lower, error, halvings - 1);
  return sign == 1 ? sign_of_parabolas(&upper, error, halvings - 1) : sign;
}

/* The same for a face whose edges are certainly positive. */
static int sign_of_face(const double beta[9]) {
  parabolas f;
  certificate c;
  parabolas_in_s(beta, &f);
  for (int j = 0; j < 3; ++j) {
    c.b[j] = f.b[j];
    c.n[j] = f.n[j];
  }
  quarter_discriminant(&f, c.d);
  const double a = greatest_magnitude(f.a, 2), b = greatest_magnitude(f.b, 3), k = greatest_magnitude(f.c, 3);
  certificate_error error = {.b = HALVED_B_ERROR,
                             .d = UNIT_ROUNDOFF *
                                  (1 + FACE_BERNSTEIN_ROUNDINGS * a + A_ROUNDINGS * k + 2 * B_ROUNDINGS * b +
                                   HALVED_D_ROUNDINGS * (a * k + b * b))}; /* (F3) */
  return sign_of_parabolas(&c, error, FILTER_HALVINGS);
}

/* The parabolas of f - bound along s (stride 3) or t (stride 1) of beta; false if B or N show that none has its vertex inside. */
static bool has_inner_vertices(const double beta[9], int along, double bound, parabolas *f) {
  const int across = 4 - along;
  for (int j = 0; j < 3; ++j) {
    const double *row = beta + across * j;
    f->b[j] = row[along] - row[0];
    f->n[j] = row[2 * along] - row[along];
    f->c[j] = row[0] - bound;
  }
  f->a[0] = f->n[0] - f->b[0];
  f->a[1] = f->n[2] - f->b[2];
  return !all_above(f->b, 3, CLEARANCE_B) && !all_below(f->n, 3, -CLEARANCE_B);
}

/* The first t in [0,1] at which the quadratic is not above CLEARANCE_B, or 1 if there is none. */
static double first_inside(double q0, double q1, double q2) {
  q0 -= CLEARANCE_B;
  q1 -= CLEARANCE_B;
  q2 -= CLEARANCE_B;
  if (q0 <= 0) return 0;
  const double quarter = q1 * q1 - q0 * q2;
  if (quarter < 0 || (q1 > 0 && q2 > 0)) return 1;
  const double root = __builtin_sqrt(quarter);
  return q1 > 0 ? (q1 + root) / (q1 + root - q2) : q0 / (q0 - q1 + root);
}

/* Bernstein coefficients of degree 4 on [0,1] become those on [from,to]. */
static void restrict_quartic(double p[5], double from, double to) {
  from /= to;
  for (int n = 1; n <= 4; ++n)
    for (int i = 4; i >= n; --i) p[i] = p[i - 1] + to * (p[i] - p[i - 1]);
  for (int n = 4; n > 0; --n)
    for (int i = 0; i < n; ++i) p[i] += from * (p[i + 1] - p[i]);
}

/* True if a quartic is certainly above CLEARANCE_D on [0,1]. */
static bool is_positive(const double d[5], int halvings) {
  if (all_above(d, 5, CLEARANCE_D)) return true;
  if (halvings == 0 || !(d[0] > CLEARANCE_D && d[4] > CLEARANCE_D)) return false;
  double lower[5], upper[5];
  halve(d, 4, lower, upper);
  return is_positive(lower, halvings - 1) && is_positive(upper, halvings - 1);
}

/* True if certainly D > 0 wherever the parabola's vertex is inside, B < 0 < N. */
static bool is_positive_inside(const parabolas *f) {
  double d[5];
  quarter_discriminant(f, d);
  if (all_above(d, 5, CLEARANCE_D)) return true;
  const double *b = f->b, *n = f->n;
  const double from = larger(first_inside(b[0], b[1], b[2]), first_inside(-n[0], -n[1], -n[2])),
               to = 1 - larger(first_inside(b[2], b[1], b[0]), first_inside(-n[2], -n[1], -n[0]));
  if (from >= to) return true;
  restrict_quartic(d, from, to);
  return is_positive(d, SKIP_HALVINGS);
}

bool face_can_be_lower(const double beta[9], double bound) {
  parabolas in_s, in_t;
  if (least_of(beta, HL_FACE_BERNSTEIN) >= bound) return false;
  return has_inner_vertices(beta, 3, bound, &in_s) && has_inner_vertices(beta, 1, bound, &in_t) &&
         !is_positive_inside(&in_s) && !is_positive_inside(&in_t);
}

static bool has_negative_candidate(const double beta[9]) {
  face_solution solution;
  find_kept_roots(beta, &solution);
  for (int r = 0; r < solution.root_count; ++r)
    if (solution.values[r] < -FACE_ERROR) return true;
  return false;
}

bool has_open_corner(const double bernstein[27]) {
  double least = bernstein[vertex_index(0)];
  for (int v = 1; v < HL_VERTICES; ++v) least = smaller(least, bernstein[vertex_index(v)]);
  return least >= -CORNER_ERROR && !(least > CORNER_ERROR);
}

bool is_settled_by_filter(const double bernstein[27], hl_verdict *verdict) {
  *verdict = HL_INVALID;
  bool certain = true;
  for (int v = 0; v < HL_VERTICES; ++v) {
    double value = bernstein[vertex_index(v)];
    if (value < -CORNER_ERROR) return true;
    if (!(value > EDGE_ERROR)) certain = false; /* an edge's middle may be as low as its ends, less its own error */
  }
  for (int e = 0; e < HL_EDGES; ++e) {
    hl_candidate candidate;
    if (bernstein[edge_bernstein[e]] > EDGE_ERROR)
      continue; /* a candidate's value is no lower than its edge's coefficients */
    if (!edge_candidate(bernstein, e, INFINITY, &candidate)) continue;
    if (candidate.value < -EDGE_ERROR) return true;
    if (!(candidate.value > EDGE_ERROR)) certain = false;
  }
  uint32_t low = 0;
  for (int i = 0; i < HL_BERNSTEIN; ++i) low |= (uint32_t)!(bernstein[i] > FACE_BERNSTEIN_ERROR) << i;
  for (int f = 0; f < HL_FACES; ++f) {
    if (certain && !(low & face_coefficient_bits[f])) continue;
    double beta[HL_FACE_BERNSTEIN];
    face_bernstein(bernstein, f, beta);
    int sign = certain ? sign_of_face(beta) : 0;
    if (sign > 0) continue;
    if (sign < 0 || has_negative_candidate(beta)) return true;
    certain = false;
  }
  if (certain) *verdict = HL_VALID;
  return certain;
}
