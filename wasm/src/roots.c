/* Roots in (0,1) of a polynomial of degree <= 4 in Bernstein form: docs/algorithm.md 5. No closed formulas: the roots of
   the derivative cut [0,1] into pieces on which the polynomial is monotone, and each piece is settled by its end signs. */
#include "bernstein.h"
#include "error_bounds.h"
#include "hexlens.h"

/* Doubles below 1 are at most this far apart: a shorter bracket says nothing more about a weight 1-t. */
#define FINEST UNIT_ROUNDOFF

HL_INLINE int sign_of(double x) { return (x > 0) - (x < 0); }

/* Value and slope at t by de Casteljau's scheme. */
static double value_at(const double *p, int degree, double t, double *slope) {
  double level[HL_QUARTIC];
  for (int i = 0; i <= degree; ++i) level[i] = p[i];
  for (int n = degree; n > 1; --n)
    for (int i = 0; i < n; ++i) level[i] = (1 - t) * level[i] + t * level[i + 1];
  *slope = degree * (level[1] - level[0]);
  return (1 - t) * level[0] + t * level[1];
}

/* At least |p''|/2 on [0,1]: second differences of coefficients are at most 4 max|p|. */
static double curvature_bound(const double *p, int degree) {
  return 2 * degree * (degree - 1) * greatest_magnitude(p, degree + 1);
}

/* The one root between low and high, where the polynomial goes from sign `sign_low` to the other: Newton's step where
   it stays inside and at least halves, else bisection. Every bisection halves the bracket, so it ends. It ends sooner
   where Kantorovich's theorem leaves an error of 4 k step^2 < FINEST after the step, k = curvature / |slope|, which it
   does for k step <= 1/4. */
static double bracketed_root(const double *p, int degree, double low, double high, int sign_low) {
  double curvature = curvature_bound(p, degree), last_step = high - low, t = low + 0.5 * last_step;
  while (high - low > FINEST) {
    double slope, value = value_at(p, degree, t, &slope);
    if (value == 0) return t;
    if (sign_of(value) == sign_low) low = t;
    else high = t;
    double step = -value / slope, next = t + step;
    if (step < 0) step = -step;
    if (slope < 0) slope = -slope;
    bool is_certain = curvature * step <= 0.25 * slope && curvature * step * step < 0.25 * FINEST * slope;
    bool is_inside = next > low && next < high;
    if (is_certain && (is_inside || next == t)) return next; /* t itself, where the step is lost in it */
    if (!(is_inside && step <= 0.5 * last_step)) {
      next = low + 0.5 * (high - low);
      step = 0.5 * (high - low);
    }
    if (step < 0.5 * FINEST) return next;
    last_step = step;
    t = next;
  }
  return low + 0.5 * (high - low);
}

static int sign_changes(const double *p, int degree) {
  int changes = 0, last = 0;
  for (int i = 0; i <= degree; ++i) {
    int sign = sign_of(p[i]);
    if (sign != 0 && last != 0 && sign != last) ++changes;
    if (sign != 0) last = sign;
  }
  return changes;
}

/* The sign just inside (0,1): that of the first coefficient that is not 0, counted from index `from` in `direction`. */
static int inner_sign(const double *p, int degree, int from, int direction) {
  for (int i = from; i >= 0 && i <= degree; i += direction)
    if (p[i] != 0) return sign_of(p[i]);
  return 0;
}

/* The sign at a root of the derivative; 0 where the value is within the rounding error of its evaluation (18), so that
   a root of even multiplicity is not lost. */
static int sign_at_extremum(const double *p, int degree, double t) {
  double magnitudes[HL_QUARTIC], slope;
  for (int i = 0; i <= degree; ++i) magnitudes[i] = fabs(p[i]);
  double value = value_at(p, degree, t, &slope);
  double error = LEVEL_ROUNDINGS * degree * UNIT_ROUNDOFF * value_at(magnitudes, degree, t, &slope);
  return value > error ? 1 : value < -error ? -1 : 0;
}

int hl_unit_roots(const double *bernstein, int degree, double roots[HL_MAX_ROOTS]) {
  int changes = sign_changes(bernstein, degree); /* at least the number of roots (Descartes) */
  if (changes == 0) return 0;

  double cuts[HL_MAX_ROOTS];
  int cut_count = 0;
  if (changes > 1) {
    double derivative[HL_QUARTIC];
    for (int i = 0; i < degree; ++i) derivative[i] = bernstein[i + 1] - bernstein[i];
    cut_count = hl_unit_roots(derivative, degree - 1, cuts);
  }
  cuts[cut_count] = 1;

  int count = 0, sign = inner_sign(bernstein, degree, 0, 1);
  double low = 0, touched = 0; /* touched: an extremum of value 0 since `low`, or 0 for none */
  for (int c = 0; c <= cut_count; ++c) {
    int next = c < cut_count ? sign_at_extremum(bernstein, degree, cuts[c]) : inner_sign(bernstein, degree, degree, -1);
    if (next == 0) {
      touched = cuts[c];
      continue;
    }
    double root = next != sign ? bracketed_root(bernstein, degree, low, cuts[c], sign) : touched;
    if (root > (count > 0 ? roots[count - 1] : 0) && root < 1) roots[count++] = root;
    sign = next;
    low = cuts[c];
    touched = 0;
  }
  return count;
}
