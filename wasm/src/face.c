/* The face's quartic P = 4a^2c' - 2abb' + a'b^2 in Bernstein form, and the points (s*(t), t) at its roots:
   docs/algorithm.md (10) to (17). With b = 2B it is P/4 = a (ac' - 2BB') + a'B^2. */
#include "face.h"
#include "bernstein.h"
#include "error_bounds.h"
#include "scaling.h"

void parabolas_in_s(const double beta[9], parabolas *f) {
  for (int j = 0; j < 3; ++j) {
    f->b[j] = beta[3 + j] - beta[j];
    f->n[j] = beta[6 + j] - beta[3 + j];
    f->c[j] = beta[j];
  }
  f->a[0] = f->n[0] - f->b[0];
  f->a[1] = f->n[2] - f->b[2];
}

/* The face with its largest coefficient brought to [1/2, 1), so that its cubes do not underflow. Returns the exponent:
   beta = unit * 2^exponent. */
static int normalized_face(const double beta[9], double unit[9]) {
  double greatest = greatest_magnitude(beta, HL_FACE_BERNSTEIN);
  int exponent = greatest > 0 ? binary_exponent(greatest) : 0;
  for (int i = 0; i < HL_FACE_BERNSTEIN; ++i) unit[i] = times_power_of_two(beta[i], -exponent);
  return exponent;
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

/* |P|/4 is at most this for |a| <= a, |B| <= b, |c'| <= dc, |B'| <= db, |a'| <= da: a coefficient of a product of
   Bernstein forms is a mean of products of coefficients. */
static double quartic_bound(double a, double b, double dc, double db, double da) {
  return a * a * dc + 2 * a * b * db + da * b * b;
}

/* The error of a computed coefficient of P, (17). The factors are those of a face normalized by
   2^-exponent, and the errors they bring along, from (8), are scaled alike. */
static double quartic_error(const parabolas *f, int exponent) {
  const double u = UNIT_ROUNDOFF, scaled_u = times_power_of_two(UNIT_ROUNDOFF, -exponent);
  double a = greatest_magnitude(f->a, 2), b = greatest_magnitude(f->b, 3), dc = 4 * greatest_magnitude(f->c, 3),
         db = 4 * b, da = 2 * a;
  double exact_at_most =
      quartic_bound(a + A_ROUNDINGS * scaled_u, b + B_ROUNDINGS * scaled_u, dc + C_SLOPE_ROUNDINGS * scaled_u,
                    db + B_SLOPE_ROUNDINGS * scaled_u, da + A_SLOPE_ROUNDINGS * scaled_u);
  return 4 * (exact_at_most - quartic_bound(a, b, dc, db, da) + QUARTIC_ROUNDINGS * u * exact_at_most);
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

typedef struct interval {
  double from, to;
} interval;

/* B and N have two roots each at most, which cut [0,1] into five intervals at most. */
enum { MAX_INTERVALS = 5 };

static void sort_ascending(double *x, int count) {
  for (int i = 1; i < count; ++i)
    for (int j = i; j > 0 && x[j] < x[j - 1]; --j) {
      double larger = x[j - 1];
      x[j - 1] = x[j];
      x[j] = larger;
    }
}

/* Intervals of t where the parabola's vertex is inside the face, B < 0 < N. */
static int inside_intervals(const parabolas *f, interval inside[MAX_INTERVALS]) {
  double cuts[2 * HL_MAX_ROOTS];
  int cut_count = hl_unit_roots(f->b, 2, cuts);
  cut_count += hl_unit_roots(f->n, 2, cuts + cut_count);
  sort_ascending(cuts, cut_count);
  cuts[cut_count++] = 1;
  int count = 0;
  double from = 0;
  for (int c = 0; c < cut_count; ++c) {
    double middle = from + 0.5 * (cuts[c] - from);
    if (quadratic_at(f->b[0], f->b[1], f->b[2], middle) < 0 && quadratic_at(f->n[0], f->n[1], f->n[2], middle) > 0)
      inside[count++] = (interval){from, cuts[c]};
    from = cuts[c];
  }
  return count;
}

/* The coefficients of the strip of the face with t in the interval; the middle ones are the polar
   form at its ends. */
static void restricted_face(const double beta[9], interval in, double strip[9]) {
  for (int i = 0; i < 3; ++i) {
    const double *q = beta + 3 * i;
    double first = lerp(q[0], q[1], in.from), second = lerp(q[1], q[2], in.from);
    strip[3 * i] = lerp(first, second, in.from);
    strip[3 * i + 1] = lerp(first, second, in.to);
    strip[3 * i + 2] = quadratic_at(q[0], q[1], q[2], in.to);
  }
}

/* The roots of P in the interval, from P of that strip of the face alone: its rounding errors are
   as small as a and B are there, while those of P on [0,1] can hide a minimizer: docs/algorithm.md
   4, "Small a and B". */
static int roots_in(interval in, const double beta[9], double t[HL_MAX_ROOTS]) {
  double strip[9], unit[9], quartic[HL_QUARTIC];
  parabolas f;
  restricted_face(beta, in, strip);
  normalized_face(strip, unit);
  parabolas_in_s(unit, &f);
  quartic_bernstein(&f, quartic);
  int found = hl_unit_roots(quartic, HL_QUARTIC - 1, t), count = 0;
  for (int r = 0; r < found; ++r) {
    double root =
        lerp(in.from, in.to, t[r]); /* in a short interval rounding can bring it to an end or to its neighbour */
    if (root > (count > 0 ? t[count - 1] : in.from) && root < in.to) t[count++] = root;
  }
  return count;
}

/* Puts a root into its place in the ascending list. Where P is little but its rounding error, the intervals can yield
   more roots than a quartic has: then the least values stay. */
static void insert_root(face_solution *solution, hl_face_root root, double value) {
  int at = solution->root_count;
  if (at < HL_MAX_ROOTS) {
    ++solution->root_count;
  } else {
    at = 0;
    for (int r = 1; r < HL_MAX_ROOTS; ++r)
      if (solution->values[r] > solution->values[at]) at = r;
    if (value >= solution->values[at]) return;
    for (; at + 1 < HL_MAX_ROOTS; ++at) {
      solution->roots[at] = solution->roots[at + 1];
      solution->values[at] = solution->values[at + 1];
    }
  }
  for (; at > 0 && root.t < solution->roots[at - 1].t; --at) {
    solution->roots[at] = solution->roots[at - 1];
    solution->values[at] = solution->values[at - 1];
  }
  solution->roots[at] = root;
  solution->values[at] = value;
}

void find_kept_roots(const double beta[9], face_solution *solution) {
  parabolas f;
  interval inside[MAX_INTERVALS];
  parabolas_in_s(beta, &f);
  int interval_count = inside_intervals(&f, inside);
  solution->root_count = 0;
  for (int i = 0; i < interval_count; ++i) {
    double t[HL_MAX_ROOTS];
    int count = roots_in(inside[i], beta, t);
    for (int r = 0; r < count; ++r) {
      hl_face_root root = examined_root(&f, t[r]);
      if (root.fate == HL_ROOT_KEPT) insert_root(solution, root, face_value(beta, root.s, t[r]));
    }
  }
}

/* The roots of P on [0,1] that are dropped, as far as there is room. */
static void add_dropped_roots(const double beta[9], face_solution *solution) {
  parabolas f;
  double t[HL_MAX_ROOTS];
  parabolas_in_s(beta, &f);
  int count = hl_unit_roots(solution->quartic, HL_QUARTIC - 1, t);
  for (int r = 0; r < count && solution->root_count < HL_MAX_ROOTS; ++r) {
    hl_face_root root = examined_root(&f, t[r]);
    if (root.fate != HL_ROOT_KEPT) insert_root(solution, root, 0);
  }
}

void solve_face(const double beta[9], face_solution *solution) {
  double unit[9];
  parabolas f;
  int exponent = normalized_face(beta, unit);
  parabolas_in_s(unit, &f);
  quartic_bernstein(&f, solution->quartic);
  for (int i = 0; i < HL_QUARTIC; ++i) solution->quartic[i] += 0.0; /* -0 becomes 0 */
  solution->quartic_exponent = 3 * exponent;
  solution->quartic_is_zero = greatest_magnitude(solution->quartic, HL_QUARTIC) <= quartic_error(&f, exponent);
  find_kept_roots(beta, solution);
  add_dropped_roots(beta, solution);
}
