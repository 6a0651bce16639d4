/* The face's quartic P = 4a^2c' - 2abb' + a'b^2 in Bernstein form, and the points (s*(t), t) at its roots:
   docs/algorithm.md (9) to (17). With b = 2B it is P/4 = a (ac' - 2BB') + a'B^2. */
#include "face.h"
#include "bernstein.h"

/* a by its two ends, B and c by three Bernstein coefficients in t; N = a + B, so that s* = -B/a = -B/(N - B). */
typedef struct parabolas {
  double a[2], b[3], n[3], c[3];
} parabolas;

static void parabolas_in_s(const double beta[9], parabolas *f) {
  for (int j = 0; j < 3; ++j) {
    f->b[j] = beta[3 + j] - beta[j];
    f->n[j] = beta[6 + j] - beta[3 + j];
    f->c[j] = beta[j];
  }
  f->a[0] = f->n[0] - f->b[0];
  f->a[1] = f->n[2] - f->b[2];
}

/* Products of Bernstein forms, (13) to (16): coefficient i of the product is a mean of products of coefficients. */
static void quartic_bernstein(const parabolas *f, double p[5]) {
  const double *a = f->a, *b = f->b;
  double dc[2] = {2 * (f->c[1] - f->c[0]), 2 * (f->c[2] - f->c[1])};
  double db[2] = {2 * (b[1] - b[0]), 2 * (b[2] - b[1])};
  double da = a[1] - a[0];

  double ac[3] = {a[0] * dc[0], 0.5 * (a[0] * dc[1] + a[1] * dc[0]), a[1] * dc[1]};
  double bb[4] = {b[0] * db[0], (2 * b[1] * db[0] + b[0] * db[1]) / 3, (b[2] * db[0] + 2 * b[1] * db[1]) / 3,
                  b[2] * db[1]};
  double g[4] = {ac[0] - 2 * bb[0], (ac[0] + 2 * ac[1]) / 3 - 2 * bb[1], (2 * ac[1] + ac[2]) / 3 - 2 * bb[2],
                 ac[2] - 2 * bb[3]};
  double square[5] = {b[0] * b[0], b[0] * b[1], (2 * b[1] * b[1] + b[0] * b[2]) / 3, b[1] * b[2], b[2] * b[2]};

  p[0] = 4 * (a[0] * g[0] + da * square[0]);
  p[1] = 4 * (0.25 * (3 * a[0] * g[1] + a[1] * g[0]) + da * square[1]);
  p[2] = 4 * (0.5 * (a[0] * g[2] + a[1] * g[1]) + da * square[2]);
  p[3] = 4 * (0.25 * (a[0] * g[3] + 3 * a[1] * g[2]) + da * square[3]);
  p[4] = 4 * (a[1] * g[3] + da * square[4]);
}

static double greatest_magnitude(const double *x, int count) {
  double greatest = 0;
  for (int i = 0; i < count; ++i) {
    double magnitude = x[i] < 0 ? -x[i] : x[i];
    if (magnitude > greatest) greatest = magnitude;
  }
  return greatest;
}

/* |P|/4 is at most this for |a| <= a, |B| <= b, |c'| <= dc, |B'| <= db, |a'| <= da: a coefficient of a product of
   Bernstein forms is a mean of products of coefficients. */
static double quartic_bound(double a, double b, double dc, double db, double da) {
  return a * a * dc + 2 * a * b * db + da * b * b;
}

/* How far a computed coefficient of P can be from the exact one: (17). */
static double quartic_error(const parabolas *f) {
  const double u = UNIT_ROUNDOFF;
  double a = greatest_magnitude(f->a, 2), b = greatest_magnitude(f->b, 3), dc = 4 * greatest_magnitude(f->c, 3),
         db = 4 * b, da = 2 * a;
  double exact_at_most = quartic_bound(a + 1004 * u, b + 466 * u, dc + 932 * u, db + 2008 * u, da + 2152 * u);
  return 4 * (exact_at_most - quartic_bound(a, b, dc, db, da) + 32 * u * exact_at_most);
}

/* The root's s* and its fate; B(t) < 0 < N(t) is the parabola's vertex strictly inside, and then a = N - B > 0. */
static hl_face_root examined_root(const parabolas *f, double t) {
  double b = quadratic_at(f->b[0], f->b[1], f->b[2], t), n = quadratic_at(f->n[0], f->n[1], f->n[2], t);
  hl_face_root root = {.t = t, .a = n - b, .s = 0, .fate = HL_ROOT_A_NOT_POSITIVE};
  if (!(root.a > 0)) return root;
  root.s = -b / root.a + 0.0;
  root.fate = b < 0 && n > 0 && root.s > 0 && root.s < 1 ? HL_ROOT_KEPT : HL_ROOT_S_OUTSIDE;
  return root;
}

static double face_value(const double beta[9], double s, double t) {
  return quadratic_at(quadratic_at(beta[0], beta[1], beta[2], t), quadratic_at(beta[3], beta[4], beta[5], t),
                      quadratic_at(beta[6], beta[7], beta[8], t), s);
}

void solve_face(const double beta[9], face_solution *solution) {
  parabolas f;
  parabolas_in_s(beta, &f);
  quartic_bernstein(&f, solution->quartic);
  for (int i = 0; i < HL_QUARTIC; ++i) solution->quartic[i] += 0.0; /* -0 becomes 0 */
  solution->quartic_is_zero = greatest_magnitude(solution->quartic, HL_QUARTIC) <= quartic_error(&f);

  double t[HL_MAX_ROOTS];
  solution->root_count = hl_unit_roots(solution->quartic, HL_QUARTIC - 1, t);
  for (int r = 0; r < solution->root_count; ++r) {
    solution->roots[r] = examined_root(&f, t[r]);
    solution->values[r] = face_value(beta, solution->roots[r].s, t[r]);
  }
}
