/* Algorithm 1010: the quartic is split into two quadratics by way of the dominant root of its resolvent cubic, the split is
   refined by Newton's method on its four coefficients, and the quadratics are solved. Only real factors are followed: two
   complex ones have no real root but a double one. */
#include "quartic.h"

#include <math.h>

#define PRECISION 0x1p-52
#define HALF_PI 1.5707963267948966
#define TWO_PI 6.2831853071795862

enum { STEPS = 8 };

static double largest(double a, double b, double c) { return fmax(fabs(a), fmax(fabs(b), fabs(c))); }

/* The dominant root of x^3 + b x + c. */
static double cubic_root(double b, double c) {
  double q = -b / 3, r = 0.5 * c, q3 = q * q * q, r2 = r * r;
  if (r2 < q3) {
    double theta = acos(r / sqrt(q3));
    return -2 * sqrt(q) * cos((theta < HALF_PI ? theta : theta + TWO_PI) / 3);
  }
  double a = -copysign(cbrt(fabs(r) + sqrt(r2 - q3)), r);
  return a == 0 ? 0 : a + q / a;
}

/* As above, then Newton's method while it improves the value. */
static double polished_cubic_root(double b, double c) {
  double x = cubic_root(b, c), value = x * (x * x + b) + c;
  if (fabs(value) <= PRECISION * largest(x * x * x, b * x, c)) return x;
  for (int i = 0; i < STEPS; ++i) {
    double slope = 3 * x * x + b;
    if (slope == 0) break;
    double next = x - value / slope, next_value = next * (next * next + b) + c;
    if (fabs(next_value) >= fabs(value)) break;
    x = next;
    value = next_value;
    if (value == 0) break;
  }
  return x;
}

/* The dominant root of the resolvent cubic of t^4 + a t^3 + b t^2 + c t + d, shifted so that it does not cancel. */
static double dominant_root(double a, double b, double c, double d) {
  double discriminant = 9 * a * a - 24 * b, s = -a / 4;
  if (discriminant > 0) s = -2 * b / (3 * a + copysign(sqrt(discriminant), a));
  double aq = a + 4 * s, bq = b + 3 * s * (a + 2 * s), cq = c + s * (2 * b + s * (3 * a + 4 * s)),
         dq = d + s * (c + s * (b + s * (a + s)));
  double gg = bq * bq / 9, hh = aq * cq;
  return polished_cubic_root(hh - 4 * dq - 3 * gg, (8 * dq + hh - 2 * gg) * bq / 3 - cq * cq - dq * aq * aq);
}

static double relative(double value, double wanted) {
  return wanted == 0 ? fabs(value) : fabs((value - wanted) / wanted);
}

typedef struct factors {
  double a, b, c, d; /* (t^2 + a t + b) (t^2 + c t + d) */
} factors;

static double error_of(factors f, double a, double b, double c, double d) {
  return relative(f.b * f.d, d) + relative(f.b * f.c + f.a * f.d, c) + relative(f.b + f.a * f.c + f.d, b) +
      relative(f.a + f.c, a);
}

/* Newton's method on the four coefficients, while it improves them. */
static factors refined(factors f, double a, double b, double c, double d) {
  double error = error_of(f, a, b, c, d);
  for (int i = 0; i < STEPS && error != 0; ++i) {
    double r3 = a - (f.a + f.c), r2 = b - (f.b + f.a * f.c + f.d), r1 = c - (f.b * f.c + f.a * f.d), r0 = d - f.b * f.d;
    double p = f.a - f.c, q = f.d - f.b, sum = r2 - f.a * r3, first = r1 - f.b * r3 - f.a * sum, second = r0 - f.b * sum;
    double determinant = (q + f.a * p) * q + f.b * p * p;
    if (determinant == 0) break;
    double da = (first * q + p * second) / determinant,
           db = ((q + f.a * p) * second - f.b * p * first) / determinant;
    factors next = {f.a + da, f.b + db, f.c + r3 - da, f.d + sum + p * da - db};
    double next_error = error_of(next, a, b, c, d);
    if (next_error >= error) break;
    f = next;
    error = next_error;
  }
  return f;
}

/* Roots of t^2 + a t + b. */
static int quadratic_roots(double a, double b, double *roots) {
  double discriminant = a * a - 4 * b;
  if (!(discriminant >= 0)) return 0;
  double larger = -0.5 * (a + copysign(sqrt(discriminant), a));
  roots[0] = larger;
  roots[1] = larger == 0 ? 0 : b / larger;
  return 2;
}

static int cubic_roots(double a, double b, double c, double *roots) {
  double shift = -a / 3, root = polished_cubic_root(b + shift * a, c + shift * (b + shift * (a + shift))) + shift;
  roots[0] = root;
  return 1 + quadratic_roots(a + root, b + root * (a + root), roots + 1);
}

/* The split L D L^T of the quartic's symmetric form: of the ways to l2 and d2 the one that reproduces the coefficients best. */
static int quartic_roots(double a, double b, double c, double d, double *roots) {
  double phi = dominant_root(a, b, c, d), l1 = a / 2, l3 = b / 6 + phi / 2, del2 = c - a * l3;
  double b0 = 2 * b / 3 - phi - l1 * l1, rest = d - l3 * l3, l2 = 0, d2 = 0, least = INFINITY;
  const double ways[3][2] = {{del2 / (2 * b0), b0}, {2 * rest / del2, del2 * del2 / (4 * rest)}, {2 * rest / del2, b0}};
  for (int w = 0; w < 3; ++w) {
    double l = ways[w][0], e = ways[w][1];
    double error = relative(e + l1 * l1 + 2 * l3, b) + relative(2 * (e * l + l1 * l3), c) +
        relative(e * l * l + l3 * l3, d);
    if (!(error < least)) continue;
    least = error;
    l2 = l;
    d2 = e;
  }
  if (d2 > PRECISION * largest(2 * b / 3, phi, l1 * l1)) return 0;
  double gamma = sqrt(fmax(-d2, 0));
  factors f = {l1 + gamma, l3 + gamma * l2, l1 - gamma, l3 - gamma * l2};
  if (fabs(f.d) < fabs(f.b)) f.d = d / f.b;
  else if (f.d != 0) f.b = d / f.d;
  if (fabs(f.a) < fabs(f.c)) f.a = a - f.c;
  else f.c = a - f.a;
  f = refined(f, a, b, c, d);
  int count = quadratic_roots(f.a, f.b, roots);
  return count + quadratic_roots(f.c, f.d, roots + count);
}

int real_roots(const double c[5], double roots[4]) {
  if (c[4] != 0) return quartic_roots(c[3] / c[4], c[2] / c[4], c[1] / c[4], c[0] / c[4], roots);
  if (c[3] != 0) return cubic_roots(c[2] / c[3], c[1] / c[3], c[0] / c[3], roots);
  if (c[2] != 0) return quadratic_roots(c[1] / c[2], c[0] / c[2], roots);
  if (c[1] == 0) return 0;
  roots[0] = -c[0] / c[1];
  return 1;
}
