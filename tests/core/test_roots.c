/* hl_unit_roots on random and on nasty polynomials, against their own signs in extended precision. */
#include "check.h"
#include "hexlens.h"
#include "random.h"

#define UNIT_ROUNDOFF 0x1p-53

static random_stream stream = {20260101};

/* Bernstein form of a product, built factor by factor; degree at most 4. */
typedef struct polynomial {
  long double p[5];
  int degree;
} polynomial;

static const long double binomial[5][5] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};

static polynomial times(polynomial a, polynomial b) {
  polynomial product = {{0}, a.degree + b.degree};
  for (int i = 0; i <= a.degree; ++i)
    for (int j = 0; j <= b.degree; ++j)
      product.p[i + j] +=
          binomial[a.degree][i] * a.p[i] * binomial[b.degree][j] * b.p[j] / binomial[product.degree][i + j];
  return product;
}

static polynomial constant(long double value) { return (polynomial){{value}, 0}; }

static polynomial with_root(long double root) { return (polynomial){{-root, 1 - root}, 1}; }

static polynomial elevated(polynomial a, int degree) {
  while (a.degree < degree) a = times(a, (polynomial){{1, 1}, 1});
  return a;
}

/* (t - m)^2 + k^2 */
static polynomial without_roots(long double m, long double k) {
  polynomial q = times(with_root(m), with_root(m));
  for (int i = 0; i < 3; ++i) q.p[i] += k * k;
  return q;
}

static long double value_at(const double *p, int degree, long double t) {
  long double level[5];
  for (int i = 0; i <= degree; ++i) level[i] = p[i];
  for (int n = degree; n > 0; --n)
    for (int i = 0; i < n; ++i) level[i] = (1 - t) * level[i] + t * level[i + 1];
  return level[0];
}

static double greatest_of(const double *p, int degree) {
  double greatest = 0;
  for (int i = 0; i <= degree; ++i) greatest = fmax(greatest, fabs(p[i]));
  return greatest;
}

/* The laws: roots ascend in (0,1); each is a zero within rounding or has a change of sign within the spacing of the
   doubles; and wherever the polynomial changes sign beyond rounding there is a root between. */
static int check_roots(const double *p, int degree, double roots[4], const char *what, long number) {
  int count = hl_unit_roots(p, degree, roots);
  /* The core's evaluation is off by at most 12 u of the greatest (18); what is within that is no sign. */
  long double noise = 16 * UNIT_ROUNDOFF * greatest_of(p, degree);
  CHECK(count >= 0 && count <= degree, "%s %ld: %d roots of degree %d", what, number, count, degree);
  for (int r = 0; r < count; ++r) {
    CHECK(roots[r] > 0 && roots[r] < 1, "%s %ld: root %g outside", what, number, roots[r]);
    CHECK(r == 0 || roots[r] > roots[r - 1], "%s %ld: roots not ascending", what, number);
    long double before = value_at(p, degree, roots[r] - 0x1p-51), after = value_at(p, degree, roots[r] + 0x1p-51);
    CHECK(fabsl(value_at(p, degree, roots[r])) <= noise || (before < 0) != (after < 0), "%s %ld: no root at %.17g",
          what, number, roots[r]);
  }
  enum { SAMPLES = 257 };
  double last = 0;
  long double last_value = 0;
  for (int i = 1; i < SAMPLES; ++i) {
    double t = (double)i / SAMPLES;
    long double value = value_at(p, degree, t);
    if (fabsl(value) <= noise) continue;
    if (last_value != 0 && (last_value < 0) != (value < 0)) {
      bool found = false;
      for (int r = 0; r < count; ++r) found = found || (roots[r] >= last && roots[r] <= t);
      CHECK(found, "%s %ld: the change of sign in [%.17g, %.17g] has no root", what, number, last, t);
    }
    last = t;
    last_value = value;
  }
  return count;
}

static int rounded(polynomial a, double p[5]) {
  for (int i = 0; i <= a.degree; ++i) p[i] = (double)a.p[i];
  return a.degree;
}

/* A root of multiplicity m moves by at most about (noise / |p^(m)/m!|)^(1/m) when the coefficients are rounded. */
static void check_found(const double roots[4], int count, double root, double within, const char *what, long number) {
  double nearest = 2;
  for (int r = 0; r < count; ++r) nearest = fmin(nearest, fabs(roots[r] - root));
  CHECK(nearest <= within, "%s %ld: root %.17g missed by %.3g, allowed %.3g", what, number, root, nearest, within);
}

static void random_coefficients(void) {
  for (long n = 0; n < TIMES(50000); ++n) {
    double p[5], roots[4];
    int degree = 1 + (int)(random_bits(&stream) % 4);
    for (int i = 0; i <= degree; ++i)
      p[i] = random_normal(&stream) * (random_bits(&stream) % 4 ? 1 : pow(10, -20 * random_unit(&stream)));
    check_roots(p, degree, roots, "random", n);
  }
}

static void known_simple_roots(void) {
  for (long n = 0; n < TIMES(20000); ++n) {
    double root[4], p[5], roots[4];
    polynomial product = constant(1 + random_unit(&stream));
    int inside = (int)(random_bits(&stream) % 5);
    for (int i = 0; i < inside; ++i) {
      root[i] = (i + 0.1 + 0.8 * random_unit(&stream)) / inside; /* apart */
      product = times(product, with_root(root[i]));
    }
    while (product.degree < 4 && random_bits(&stream) % 3)
      product = times(product,
                      with_root(random_bits(&stream) % 2 ? -0.2 - random_unit(&stream) : 1.2 + random_unit(&stream)));
    int degree = rounded(elevated(product, 4), p);
    int count = check_roots(p, degree, roots, "simple", n);
    CHECK(count == inside, "simple %ld: %d roots, not %d", n, count, inside);
    for (int i = 0; i < inside; ++i) check_found(roots, count, root[i], 1e4 * UNIT_ROUNDOFF, "simple", n);
  }
}

/* Double, triple and quadruple roots, with what is left of the degree elsewhere. */
static void multiple_roots(void) {
  for (long n = 0; n < TIMES(20000); ++n) {
    double p[5], roots[4];
    int multiplicity = 2 + (int)(random_bits(&stream) % 3);
    double root = (double)(1 + random_bits(&stream) % 63) / 64;
    if (n % 2) root = 0.05 + 0.9 * random_unit(&stream);
    polynomial product = constant(random_bits(&stream) % 2 ? 1 : -1);
    for (int i = 0; i < multiplicity; ++i) product = times(product, with_root(root));
    if (multiplicity == 2 && n % 3 == 0) product = times(product, without_roots(random_unit(&stream), 0.5));
    if (multiplicity == 2 && n % 3 == 1) product = times(product, with_root(1.5));
    if (multiplicity == 3 && n % 2) product = times(product, with_root(-0.5));
    int degree = rounded(elevated(product, 4), p);
    int count = check_roots(p, degree, roots, "multiple", n);
    double within = 8 * pow(16 * UNIT_ROUNDOFF * greatest_of(p, degree) / 0.1, 1.0 / multiplicity);
    check_found(roots, count, root, within, "multiple", n);
  }
}

/* Two double roots, where the polynomial only touches zero, and pairs of roots 1e-3 to 1e-9 apart. */
static void pairs(void) {
  for (long n = 0; n < TIMES(20000); ++n) {
    double p[5], roots[4], x = 0.1 + 0.3 * random_unit(&stream), y = 0.6 + 0.3 * random_unit(&stream);
    bool touching = n % 2;
    double gap = touching ? 0 : pow(10, -3 - 6 * random_unit(&stream));
    polynomial product = times(times(with_root(x), with_root(x + gap)), times(with_root(y), with_root(y + gap)));
    int degree = rounded(product, p);
    int count = check_roots(p, degree, roots, "pairs", n);
    double within = 8 * sqrt(16 * UNIT_ROUNDOFF * greatest_of(p, degree) / 0.01);
    check_found(roots, count, x, within, "pairs", n);
    check_found(roots, count, y, within, "pairs", n);
  }
}

/* The leading coefficients are roundoff: powers of t, from t^4 down, with factors of 1e-33. */
static void vanishing_leading_coefficients(void) {
  for (long n = 0; n < TIMES(20000); ++n) {
    double p[5], roots[4], x = 0.05 + 0.4 * random_unit(&stream), y = 0.55 + 0.4 * random_unit(&stream);
    int true_degree = 1 + (int)(random_bits(&stream) % 3);
    polynomial product = with_root(x);
    if (true_degree >= 2) product = times(product, with_root(y));
    if (true_degree >= 3) product = times(product, with_root(-1));
    product = elevated(product, 4);
    product.p[4] += 1e-33L * (n % 2 ? 1 : -1); /* t^4 in Bernstein form is (0,0,0,0,1) */
    int degree = rounded(product, p);
    if (n % 3 == 0) /* roundoff in every coefficient, as a computed P has it */
      for (int i = 0; i < 5; ++i) p[i] += UNIT_ROUNDOFF * random_normal(&stream);
    int count = check_roots(p, degree, roots, "leading", n);
    check_found(roots, count, x, 1e4 * UNIT_ROUNDOFF, "leading", n);
    if (true_degree >= 2) check_found(roots, count, y, 1e4 * UNIT_ROUNDOFF, "leading", n);
  }
}

static void extreme_coefficients(void) {
  double roots[4];
  const double zero[5] = {0}, ends[5] = {0, 1, 1, 1, 0}, touching_ends[5] = {0, -1, 2, -1, 0};
  CHECK(hl_unit_roots(zero, 4, roots) == 0, "the zero polynomial has roots");
  CHECK(hl_unit_roots(ends, 4, roots) == 0, "roots at 0 and 1 are not in (0,1)");
  CHECK(hl_unit_roots(touching_ends, 4, roots) == 2, "two roots between roots at the ends");
  const double between_ends[5] = {0, -3, 6, 0, 0};
  CHECK(hl_unit_roots(between_ends, 4, roots) == 1 && roots[0] == 0.25, "a root is lost to those at the ends");
  const double constant_p[5] = {3, 3, 3, 3, 3};
  CHECK(hl_unit_roots(constant_p, 4, roots) == 0, "a constant has roots");
  for (int exponent = -300; exponent <= 300; exponent += 50) {
    double scale = pow(2, exponent), p[5] = {-scale, scale, scale, scale, scale};
    CHECK(hl_unit_roots(p, 4, roots) == 1, "2^%d: root lost", exponent);
    double tiny[5] = {-scale, 1, 1, 1, 1};
    if (exponent < 0 && exponent > -50) CHECK(hl_unit_roots(tiny, 4, roots) == 1, "root near 0 lost, 2^%d", exponent);
  }
}

int main(void) {
  RUN(random_coefficients);
  RUN(known_simple_roots);
  RUN(multiple_roots);
  RUN(pairs);
  RUN(vanishing_leading_coefficients);
  RUN(extreme_coefficients);
  return test_summary();
}
