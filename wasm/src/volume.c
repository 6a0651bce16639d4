/* Branch and bound: boxes of the element in Bernstein form, bounded from below by their
   coefficients or by a convex underestimator, and settled once the bound is no longer below the
   least value found: docs/algorithm.md 8. */
#include "volume.h"
#include "bernstein.h"
#include "error_bounds.h"
#include "subdivision.h"
#include "topology.h"

/* A box's bound may stay this much, relative to the largest coefficient, below the least value
   found. */
#define TOLERANCE 0x1p-35

/* Halvings of one axis; the boxes of an element of doubles are dyadic, and 2^-40 wide their
   coefficients are one number. */
enum { MAX_HALVINGS = 40, MAX_STACK = 3 * MAX_HALVINGS + 2 };

/* Parts looked at before what is left is settled by its bounds as they are: no element may hang. */
enum { WORK_LIMIT = 100000 };

enum { NEWTON_STEPS = 4 };

typedef struct box {
  double b[27];
  double from[3], width[3]; /* a width of 0: the minimum over the box lies on that side */
} box;

typedef struct search {
  double unit; /* max|bernstein| */
  double best; /* the least value found */
  double point[3];
  double lower; /* the least bound of a settled box */
} search;

static bool can_be_settled(const search *s, double bound) { return bound >= s->best - TOLERANCE * s->unit; }

static void settle(search *s, double bound) { s->lower = smaller(s->lower, bound); }

static void found_value(search *s, const box *p, const double t[3], double value) {
  if (!(value < s->best)) return;
  s->best = value;
  for (int axis = 0; axis < 3; ++axis) s->point[axis] = p->from[axis] + t[axis] * p->width[axis];
}

static void look_at_corners(search *s, const box *p) {
  for (int v = 0; v < 8; ++v) found_value(s, p, vertex_point[v], p->b[vertex_index(v)]);
}

/* If jacdet does not fall along an axis its least values lie on the box's lower side, and if it
   does not rise on the upper: the box becomes that side. Nothing is computed but comparisons, so
   nothing is rounded. */
static void drop_to_side(box *p, int axis) {
  int stride = axis_stride[axis];
  bool rises = true, falls = true;
  for (int i = 0; i < 27; ++i) {
    if (axis_digit(i, axis) == 2) continue;
    if (p->b[i + stride] < p->b[i]) rises = false;
    if (p->b[i + stride] > p->b[i]) falls = false;
  }
  if (!rises && !falls) return;
  for (int i = 0; i < 27; ++i) {
    if (axis_digit(i, axis) != 0) continue;
    p->b[i] = rises ? p->b[i] : p->b[i + 2 * stride];
    p->b[i + stride] = p->b[i + 2 * stride] = p->b[i];
  }
  if (!rises) p->from[axis] += p->width[axis];
  p->width[axis] = 0;
}

/* Bernstein polynomials of degree 2 and their derivatives. */
static void basis(double t, double w[3], double dw[3]) {
  w[0] = (1 - t) * (1 - t);
  w[1] = 2 * t * (1 - t);
  w[2] = t * t;
  dw[0] = -2 * (1 - t);
  dw[1] = 2 - 4 * t;
  dw[2] = 2 * t;
}

/* jacdet and its gradient by t, the box's own coordinates in [0,1]^3. */
static double value_and_gradient(const box *p, const double t[3], double gradient[3]) {
  double w[3][3], dw[3][3], value = 0;
  for (int axis = 0; axis < 3; ++axis) {
    basis(t[axis], w[axis], dw[axis]);
    gradient[axis] = 0;
  }
  for (int i = 0; i < 27; ++i) {
    int x = axis_digit(i, 0), y = axis_digit(i, 1), z = axis_digit(i, 2);
    value += p->b[i] * (w[0][x] * w[1][y] * w[2][z]);
    gradient[0] += p->b[i] * (dw[0][x] * w[1][y] * w[2][z]);
    gradient[1] += p->b[i] * (w[0][x] * dw[1][y] * w[2][z]);
    gradient[2] += p->b[i] * (w[0][x] * w[1][y] * dw[2][z]);
  }
  return value;
}

typedef struct range {
  double low, high;
} range;

static void include(range *r, double x) {
  if (x < r->low) r->low = x;
  if (x > r->high) r->high = x;
}

/* The range of the second derivatives by t: the hull of their Bernstein coefficients. */
static range second_derivative(const box *p, int first, int second) {
  int f = axis_stride[first], s = axis_stride[second];
  range r = {__DBL_MAX__, -__DBL_MAX__};
  for (int i = 0; i < 27; ++i) {
    const double *b = p->b + i;
    if (first == second) {
      if (axis_digit(i, first) == 0) include(&r, 2 * (b[0] - 2 * b[f] + b[2 * f]));
    } else if (axis_digit(i, first) < 2 && axis_digit(i, second) < 2) {
      include(&r, 4 * ((b[f + s] - b[f]) - (b[s] - b[0])));
    }
  }
  return r;
}

/* A = L D L^T with positive D, unless A is not positive definite. Flat axes are given 1 on the diagonal. */
typedef struct factors {
  double d[3], l10, l20, l21;
} factors;

static bool factorize(double a[3][3], factors *f) {
  f->d[0] = a[0][0];
  if (!(f->d[0] > 0)) return false;
  f->l10 = a[1][0] / f->d[0];
  f->l20 = a[2][0] / f->d[0];
  f->d[1] = a[1][1] - f->l10 * a[1][0];
  if (!(f->d[1] > 0)) return false;
  double c = a[2][1] - f->l20 * a[1][0];
  f->l21 = c / f->d[1];
  f->d[2] = a[2][2] - f->l20 * a[2][0] - f->l21 * c;
  return f->d[2] > 0;
}

static void solve(const factors *f, const double g[3], double x[3]) {
  double y1 = g[1] - f->l10 * g[0], y2 = g[2] - f->l20 * g[0] - f->l21 * y1;
  x[2] = y2 / f->d[2];
  x[1] = y1 / f->d[1] - f->l21 * x[2];
  x[0] = g[0] / f->d[0] - f->l10 * x[1] - f->l20 * x[2];
}

static double clamped_to_unit(double t) { return t < 0 ? 0 : t > 1 ? 1 : t; }

/* The least value over the box of the tangent plane at the convex underestimator's minimizer, or
   near it: (V6). */
static double tangent_bound(search *s, const box *p, const factors *f, double alpha) {
  double t[3] = {0.5, 0.5, 0.5}, gradient[3], step[3], value = 0;
  for (int n = 0; n <= NEWTON_STEPS; ++n) {
    value = value_and_gradient(p, t, gradient);
    found_value(s, p, t, value);
    for (int axis = 0; axis < 3; ++axis) {
      if (p->width[axis] == 0) continue;
      value -= alpha * t[axis] * (1 - t[axis]);
      gradient[axis] -= alpha * (1 - 2 * t[axis]);
    }
    if (n == NEWTON_STEPS) break;
    solve(f, gradient, step);
    for (int axis = 0; axis < 3; ++axis)
      if (p->width[axis] > 0) t[axis] = clamped_to_unit(t[axis] - step[axis]);
  }
  double bound = value - TANGENT_ROUNDINGS * UNIT_ROUNDOFF * s->unit;
  for (int axis = 0; axis < 3; ++axis)
    if (p->width[axis] > 0) bound += smaller(-gradient[axis] * t[axis], gradient[axis] * (1 - t[axis]));
  return bound;
}

/* jacdet - alpha sum t(1-t) is convex on the box if the Hessian's centre, plus 2 alpha and less its
   radius, is positive definite; tried with alpha = 0 and, for a valley whose floor is flat, with
   the radius: (V4), (V5). */
static bool settled_by_convexity(search *s, const box *p) {
  double centre[3][3], radius = 0, row[3] = {0, 0, 0};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j) {
      bool flat = p->width[i] == 0 || p->width[j] == 0;
      range r = flat ? (range){i == j, i == j} : second_derivative(p, i, j);
      centre[i][j] = centre[j][i] = 0.5 * r.low + 0.5 * r.high;
      double half = 0.5 * r.high - 0.5 * r.low;
      row[i] += half;
      if (i != j) row[j] += half;
    }
  for (int i = 0; i < 3; ++i)
    if (row[i] > radius) radius = row[i];
  radius += HESSIAN_ROUNDINGS * UNIT_ROUNDOFF * s->unit;
  for (int attempt = 0; attempt < 2; ++attempt) {
    double alpha = attempt == 0 ? 0 : radius, shifted[3][3];
    if (0.75 * alpha > TOLERANCE * s->unit) return false;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) shifted[i][j] = centre[i][j] + (i == j && p->width[i] > 0 ? 2 * alpha - radius : 0);
    factors f;
    if (!factorize(shifted, &f)) continue;
    double bound = tangent_bound(s, p, &f, alpha);
    if (!can_be_settled(s, bound)) continue;
    settle(s, bound);
    return true;
  }
  return false;
}

/* The axis along which neighbouring coefficients differ most, of those that can be halved; -1 if there is none. */
static int axis_to_halve(const box *p) {
  int chosen = -1;
  double greatest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (p->width[axis] <= 1.0 / ((long long)1 << MAX_HALVINGS)) continue;
    for (int i = 0; i < 27; ++i) {
      if (axis_digit(i, axis) == 2) continue;
      double difference = fabs(p->b[i + axis_stride[axis]] - p->b[i]);
      if (chosen < 0 || difference > greatest) {
        chosen = axis;
        greatest = difference;
      }
    }
  }
  return chosen;
}

static void halve_box(const box *p, int axis, box *lower, box *upper) {
  *lower = *upper = *p;
  halve_along(p->b, axis, lower->b, upper->b);
  lower->width[axis] = upper->width[axis] = 0.5 * p->width[axis];
  upper->from[axis] += upper->width[axis];
}

/* Settles the box or leaves it cut to the side or sides on which its minimum lies; true if it is
   still open. */
static bool stays_open(search *s, box *p) {
  double bound = least_coefficient(p->b);
  if (!can_be_settled(s, bound)) {
    for (int axis = 0; axis < 3; ++axis)
      if (p->width[axis] > 0) drop_to_side(p, axis);
    look_at_corners(s, p);
    bound = least_coefficient(p->b);
  }
  if (!can_be_settled(s, bound)) return !settled_by_convexity(s, p);
  settle(s, bound);
  return false;
}

/* Depth first, the half with the lower bound before the other: no more than a stack is needed, and good values come early. */
static void search_boxes(search *s, const box *whole) {
  box stack[MAX_STACK];
  int count = 0, looked_at = 0;
  stack[count++] = *whole;
  while (count > 0) {
    box p = stack[--count];
    if (++looked_at > WORK_LIMIT) {
      settle(s, least_coefficient(p.b));
      continue;
    }
    if (!stays_open(s, &p)) continue;
    int axis = axis_to_halve(&p);
    if (axis < 0) {
      settle(s, least_coefficient(p.b));
      continue;
    }
    box lower, upper;
    halve_box(&p, axis, &lower, &upper);
    bool lower_first = least_coefficient(lower.b) < least_coefficient(upper.b);
    stack[count++] = lower_first ? upper : lower;
    stack[count++] = lower_first ? lower : upper;
  }
}

hl_volume_minimum bracketed_volume_minimum(const double bernstein[27], double error, const hl_candidate *start) {
  box whole = {.width = {1, 1, 1}};
  for (int i = 0; i < 27; ++i) whole.b[i] = bernstein[i];
  search s = {.unit = greatest_magnitude(bernstein, 27), .best = start->value, .lower = start->value};
  for (int axis = 0; axis < 3; ++axis) s.point[axis] = start->point[axis];
  search_boxes(&s, &whole);

  double gradient[3], u = UNIT_ROUNDOFF * s.unit;
  double value = value_and_gradient(&whole, s.point, gradient);
  hl_volume_minimum minimum = {
      .lower = s.lower - error - 3 * MAX_HALVINGS * PART_HALVING_ROUNDINGS * u,
      .upper = value + error + PART_VALUE_ROUNDINGS * u,
  };
  for (int axis = 0; axis < 3; ++axis) minimum.point[axis] = s.point[axis];
  return minimum;
}
