/* The exact stage on what is known by construction: signs and minima of faces that touch zero in every way there is, volumes, classes,
   shapes, and the candidates of reports. */
#include "../../wasm/src/exact.h"
#include "../../wasm/src/exact_face.h"
#include "../../wasm/src/exact_jacdet.h"
#include "../../wasm/src/report.h"
#include "check.h"
#include "hexlens.h"
#include "random.h"
#include "reference.h"

#include <float.h>
#include <string.h>

enum { CAPACITY = 280000 };
static uint32_t limbs[CAPACITY];
static random_stream stream = {20261101};

static workspace whole_workspace(void) { return (workspace){.limbs = limbs, .capacity = CAPACITY}; }

static int64_t between(int64_t low, int64_t high) {
  return low + (int64_t)(random_bits(&stream) % (uint64_t)(high - low + 1));
}

/* Faces. A quadratic in t is its three Bernstein coefficients, times any positive number. */

typedef struct quadratic {
  int64_t q[3];
} quadratic;

/* m times (r t - u)^2, and m times (r t - u)(v t - w); twice the coefficients of the latter. */
static quadratic product_of_lines(int64_t m, int64_t r, int64_t u, int64_t v, int64_t w) {
  const int64_t at_0 = u * w, at_1 = (r - u) * (v - w), middle = -(r - u) * w - u * (v - w);
  return (quadratic){{2 * m * at_0, m * middle, 2 * m * at_1}};
}

static quadratic plus(quadratic a, quadratic b, int64_t times) {
  for (int i = 0; i < 3; ++i) a.q[i] += times * b.q[i];
  return a;
}

static const quadratic one = {{1, 1, 1}};

static quadratic times(int64_t m, quadratic a) {
  for (int i = 0; i < 3; ++i) a.q[i] *= m;
  return a;
}

typedef struct small_face {
  quadratic row[3];
} small_face;

/* a s^2 + 2 B s + c: its coefficients along s are c, c + B, a + 2 B + c. */
static small_face face_of_parabolas(quadratic a, quadratic b, quadratic c) {
  return (small_face){{c, plus(c, b, 1), plus(plus(c, b, 2), a, 1)}};
}

/* A unit: 1, 2^3000, or an odd integer of 1200 bits. */
static integer unit_of(workspace *w, int kind) {
  integer unit = integer_of(w, 1);
  if (kind == 1) return integer_shifted(w, unit, 3000);
  for (int i = 0; kind == 2 && i < 40; ++i)
    unit = integer_sum(w, integer_shifted(w, unit, 30), integer_of(w, between(0, 1 << 30) | 1));
  return unit;
}

/* One of the eight symmetries of the square, by bits: s reversed, t reversed, s and t exchanged. */
static exact_face placed(workspace *w, const small_face *f, integer unit, int symmetry) {
  exact_face out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int s = symmetry & 1 ? 2 - i : i, t = symmetry & 2 ? 2 - j : j;
      const integer value = integer_product(w, unit, integer_of(w, f->row[i].q[j]));
      *(symmetry & 4 ? &out.beta[t][s] : &out.beta[s][t]) = value;
    }
  return out;
}

enum { NOT_NEGATIVE = 2 };

static void has_sign(const small_face *f, int expected, const char *what, long n) {
  for (int symmetry = 0; symmetry < 8; ++symmetry) {
    workspace w = whole_workspace();
    const exact_face face = placed(&w, f, unit_of(&w, (int)(n % 3)), symmetry);
    const int sign = exact_face_sign(&w, &face);
    CHECK(!w.is_full && (expected == NOT_NEGATIVE ? sign >= 0 : sign == expected),
          "%s %ld, symmetry %d: sign %d, not %d", what, n, symmetry, sign, expected);
  }
}

/* A(q s - p)^2 + C(r t - u)^2 + e, four times, with its least value e at (p/q, u/r); dyadic places are among them. */
typedef struct well {
  int64_t a, q, p, c, r, u, e;
} well;

static well random_well(int64_t e) {
  well x = {.a = between(1, 5), .c = between(1, 5), .e = e};
  const int64_t most = random_bits(&stream) % 2 ? 9 : 1 << 20;
  x.q = random_bits(&stream) % 3 ? between(2, most) : (int64_t)2 << between(0, 15);
  x.r = random_bits(&stream) % 3 ? between(2, most) : (int64_t)2 << between(0, 15);
  x.p = between(1, x.q - 1);
  x.u = between(1, x.r - 1);
  return x;
}

static small_face face_of_well(const well *x) {
  const quadratic in_t = plus(product_of_lines(2 * x->c, x->r, x->u, x->r, x->u), one, 4 * x->e);
  return face_of_parabolas(times(4 * x->a * x->q * x->q, one), times(-4 * x->a * x->q * x->p, one),
                           plus(in_t, one, 4 * x->a * x->p * x->p));
}

static void wells_have_the_sign_of_their_least_value(void) {
  for (long n = 0; n < TIMES(800); ++n) {
    const well x = random_well(n % 4 == 0 ? 0 : n % 4 == 1 ? -1 : between(-1, 2));
    const small_face f = face_of_well(&x);
    has_sign(&f, (x.e > 0) - (x.e < 0), "well", n);
  }
}

/* s* = 1/2 + k x^2 with x = t - u/r, D = 4 m x^2 - 16 k^2 x^4: a double root with a value of 0, and positive edges since m > 4 k^2. */
static void touches_on_curved_valleys(void) {
  for (long n = 0; n < TIMES(120); ++n) {
    const int64_t r = n % 2 ? between(2, 40) : (int64_t)2 << between(0, 4), u = between(1, r - 1), m = between(5, 9);
    const quadratic square = product_of_lines(1, r, u, r, u), whole = times(2 * r * r, one); /* 2 r^2 x^2 and 2 r^2 */
    const small_face f =
        face_of_parabolas(times(4, whole), plus(times(-2, whole), square, -4), plus(whole, square, 4 + m));
    has_sign(&f, 0, "touch", n);
  }
}

/* (1 + x) s^2 - s + (1 - x + x^2)/4 with x = t - u/r: D = x^3/4. */
static void triple_roots_are_negative_on_one_side(void) {
  for (long n = 0; n < TIMES(200); ++n) {
    const int64_t r = n % 2 ? between(2, 40) : (int64_t)2 << between(0, 4), u = between(1, r - 1);
    const quadratic whole = times(8 * r * r, one), x = {{-8 * r * u, 4 * r * (r - 2 * u), 8 * r * (r - u)}},
                    square = product_of_lines(1, r, u, r, u);
    quadratic c = plus(times(2 * r * r, one), square, 1);
    for (int i = 0; i < 3; ++i) c.q[i] -= x.q[i] / 4;
    const small_face f = face_of_parabolas(plus(whole, x, 1), times(-4 * r * r, one), c);
    has_sign(&f, -1, "triple root", n);
  }
}

/* beta_0 = a P^2, beta_2 = c Q^2, beta_1 = k P Q for lines P and Q in t: D = (a c - k^2) P^2 Q^2, identically 0 for k^2 = a c. For
   k > 0 beta_1 < 0 between the roots of P and Q alone, for k < 0 at the ends as well: then the edges are negative for k^2 > a c. */
static void edges_that_touch_zero_inside(void) {
  for (long n = 0; n < TIMES(120); ++n) {
    const int64_t r = between(2, 30), u = between(1, r - 1), v = n % 3 ? between(2, 30) : r,
                  x = n % 3 ? between(1, v - 1) : u, a = between(1, 4), c = between(1, 4), k = between(-2, 5);
    const small_face f = {
        {product_of_lines(a, r, u, r, u), product_of_lines(k, r, u, v, x), product_of_lines(c, v, x, v, x)}};
    const bool has_small_middle = k * k <= a * c;
    if (k > 0 || has_small_middle) has_sign(&f, has_small_middle || u * v == x * r ? NOT_NEGATIVE : -1, "two edges", n);
    /* One edge only, and the rest above. */
    small_face other = {{f.row[0], times(0, one), times(7, one)}};
    has_sign(&other, NOT_NEGATIVE, "one edge", n);
    other.row[1] = times(-1, one); /* D = 7 beta_0 - 1 < 0 where beta_0 is 0 */
    has_sign(&other, -1, "one edge and a negative middle", n);
  }
}

static void edges_that_are_zero(void) {
  static const struct {
    quadratic middle;
    int sign;
  } middles[] = {{{{1, -1, 1}}, NOT_NEGATIVE}, {{{1, -2, 1}}, -1},          {{{4, -2, 1}}, NOT_NEGATIVE},
                 {{{4, -3, 1}}, -1},           {{{0, 0, 0}}, NOT_NEGATIVE}, {{{0, -1, 0}}, -1},
                 {{{0, 2, 0}}, NOT_NEGATIVE},  {{{2, 1, 3}}, NOT_NEGATIVE}};
  for (size_t i = 0; i < sizeof middles / sizeof *middles; ++i)
    for (long n = 0; n < 3; ++n) {
      const small_face f = {{times(0, one), middles[i].middle, times(n, one)}};
      has_sign(&f, middles[i].sign, "zero edge", n + 3 * (long)i);
    }
}

/* beta_1 = -P^2 with its double root inside, beta_0 = beta_2 = P^2 + e: D = 2 e P^2 + e^2. */
static void middles_with_a_double_root(void) {
  for (long n = 0; n < TIMES(300); ++n) {
    const int64_t r = between(2, 50), u = between(1, r - 1), e = n % 2;
    const quadratic square = product_of_lines(1, r, u, r, u), edge = plus(square, one, e);
    const small_face f = {{edge, times(-1, square), edge}};
    has_sign(&f, e == 0 ? NOT_NEGATIVE : 1, "double root", n);
  }
}

/* A corner that is 0: beta_0 = t or t^2, beta_1 = -2 k t (1-t), beta_2 = 1. D is t - 4 k^2 t^2 (1-t)^2, or t^2 (1 - 4 k^2 (1-t)^2). */
static void corners_that_are_zero(void) {
  const quadratic line = {{0, 4, 8}}, square = {{0, 0, 8}}, whole = {{8, 8, 8}};
  for (int eighths = 0; eighths <= 24; ++eighths) {
    const quadratic middle = {{0, -eighths, 0}};
    const small_face f = {{line, middle, whole}}, g = {{square, middle, whole}};
    /* t (1-t)^2 is at most 4/27: negative for 4 k^2 > 27/4. */
    has_sign(&f, 4 * 4 * eighths * eighths > 27 * 64 ? -1 : NOT_NEGATIVE, "line from a corner", eighths);
    has_sign(&g, 2 * eighths > 8 ? -1 : NOT_NEGATIVE, "square from a corner", eighths);
  }
}

static int64_t smaller_of(int64_t a, int64_t b) { return a < b ? a : b; }

/* The least value on the edges of a well with e = 0. */
static int64_t least_on_edges(const well *x) {
  return smaller_of(x->a * smaller_of(x->p * x->p, (x->q - x->p) * (x->q - x->p)),
                    x->c * smaller_of(x->u * x->u, (x->r - x->u) * (x->r - x->u)));
}

static void minima_of_wells_are_found(void) {
  for (long n = 0; n < TIMES(1200); ++n) {
    workspace w = whole_workspace();
    well x = random_well(0);
    const int64_t edges = least_on_edges(&x);
    x.e = n % 3 == 0 ? -between(1, 5) : n % 3 == 1 ? between(1, 1 << 20) : -edges - between(0, 9);
    const small_face f = face_of_well(&x);
    const integer unit = unit_of(&w, (int)(n / 3 % 3));
    const exact_face face = placed(&w, &f, unit, 0);
    const double s = (double)x.p / (double)x.q, t = (double)x.u / (double)x.r;
    const double roots[3] = {random_unit(&stream), n % 2 ? t : 0.25, 1 - 0x1p-53};
    least_value least = {.numerator = integer_product(&w, unit, integer_of(&w, 4 * (edges + x.e))),
                         .denominator = integer_of(&w, 1)};
    if (x.e < 0 && is_zero(least.numerator)) continue;
    const bool is_lower = exact_face_lowers(&w, &face, roots, (int)(n % 4), &least);
    const scaled_double value = rounded_quotient(&w, least.numerator, least.denominator, 0),
                        expected = rounded_integer(&w, integer_product(&w, unit, integer_of(&w, 4 * x.e)), 0);
    CHECK(!w.is_full && is_lower, "%ld: not lower", n);
    CHECK(fabs(ldexp(value.mantissa, value.exponent - expected.exponent) - expected.mantissa) <=
              0x1p-52 * fabs(expected.mantissa),
          "%ld: minimum %a 2^%d, not %a 2^%d", n, value.mantissa, value.exponent, expected.mantissa, expected.exponent);
    /* A value within 2^-57 of e is at a point within 2^-28 sqrt(|e| / A) / q of the place. */
    const double near = 0x1p-28 * sqrt(fabs((double)x.e)) + 0x1p-52;
    CHECK(fabs(least.s - s) <= near && fabs(least.t - t) <= near, "%ld: at (%.17g, %.17g), not (%.17g, %.17g)", n,
          least.s, least.t, s, t);
  }
}

/* The floor that a search stays above can be the minimum itself, as here: four times -1. */
static void searches_end_where_the_floor_is_the_minimum(void) {
  for (long n = 0; n < TIMES(3000); ++n) {
    workspace w = {.limbs = limbs, .capacity = 40000};
    well x = random_well(-1);
    const small_face f = face_of_well(&x);
    const exact_face face = placed(&w, &f, integer_of(&w, 1), (int)(n % 8));
    least_value least = {.numerator = integer_of(&w, 4 * (least_on_edges(&x) - 1)), .denominator = integer_of(&w, 1)};
    if (is_zero(least.numerator)) continue;
    const bool is_lower = exact_face_lowers(&w, &face, NULL, 0, &least);
    CHECK(is_lower && !w.is_full, "%ld: lower: %d, full: %d", n, is_lower, w.is_full);
  }
}

/* The point may be hidden at 2^-80 of the largest coefficient, or not be near a double's root. */
static void places_of_touching_are_found(void) {
  for (long n = 0; n < TIMES(2000); ++n) {
    workspace w = whole_workspace();
    const well x = random_well(0);
    const small_face f = face_of_well(&x);
    exact_face face = placed(&w, &f, unit_of(&w, (int)(n % 3)), 0);
    const double s = (double)x.p / (double)x.q, t = (double)x.u / (double)x.r;
    const double roots[2] = {random_unit(&stream), n % 5 ? 0.25 : t};
    least_value least;
    exact_face_touch(&w, &face, roots, (int)(n % 3), &least);
    /* A value of at most 2^-64 M, M the largest coefficient, is within 2^-32 sqrt(M / C) / r of t, and of s alike. */
    double most = 0;
    for (int i = 0; i < 9; ++i) most = fmax(most, fabs((double)f.row[i / 3].q[i % 3]));
    const double near_s = 0x1p-32 * sqrt(most / (double)x.a) / (double)x.q + 0x1p-50,
                 near_t = 0x1p-32 * sqrt(most / (double)x.c) / (double)x.r + 0x1p-50;
    CHECK(!w.is_full && fabs(least.s - s) <= near_s && fabs(least.t - t) <= near_t,
          "%ld: at (%.17g, %.17g), not (%.17g, %.17g)", n, least.s, least.t, s, t);
  }
  /* (2 s - 1)^2 + 2^-80 (2 t - 1)^2, times 4 2^80 */
  for (int zeros = 10; zeros < 300; zeros += 10) {
    workspace w = whole_workspace();
    const integer much = integer_shifted(&w, integer_of(&w, 1), zeros), little = integer_of(&w, 1);
    exact_face face;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const integer in_s = i == 1 ? integer_negated(much) : much, in_t = j == 1 ? integer_negated(little) : little;
        face.beta[i][j] = integer_sum(&w, in_s, in_t);
      }
    least_value least;
    exact_face_touch(&w, &face, NULL, 0, &least);
    CHECK(!w.is_full && least.s == 0.5 && is_positive(least.denominator) && least.t > 0 && least.t < 1,
          "%d: at (%g, %g)", zeros, least.s, least.t);
  }
}

/* Elements. */

/* Random ones, small integers, flat and nearly flat ones, wide exponents, any bits. */
static void any_hexahedron(long n, double v[24]) {
  random_hexahedron(&stream, 0.05 * (double)(n % 30), v);
  const int kind = (int)(n % 6);
  for (int i = 0; i < 24; ++i) {
    if (kind == 1) v[i] = floor(3 * v[i]) / 2;
    if (kind == 2) v[i] = i % 3 == 2 ? ldexp(v[i], -40) : floor(8 * v[i]);
    if (kind == 3) v[i] = ldexp(v[i], (int)between(-900, 900));
    if (kind == 4) v[i] = i >= 12 ? v[i - 12] + (i % 3 == 2) * ldexp(1, (int)between(-60, -1)) : v[i];
    if (kind == 5) v[i] = unit_cube[i] + (double)between(-2, 2) * 0x1p-50;
  }
}

static void volumes_are_the_mean_of_the_coefficients(void) {
  for (long n = 0; n < TIMES(6000); ++n) {
    double v[24];
    any_hexahedron(n, v);
    workspace w = whole_workspace();
    exact_jacdet jacdet;
    exact_bernstein(&w, v, &jacdet);
    integer sum = zero;
    for (int i = 0; i < HL_BERNSTEIN; ++i) sum = integer_sum(&w, sum, jacdet.bernstein[i]);
    sum = integer_sum(&w, integer_shifted(&w, sum, 2), exact_cube_centre(&w, &jacdet));
    const scaled_double mean = rounded_quotient(&w, sum, integer_of(&w, 27), jacdet.exponent - 4),
                        volume = find_volume(v), exact = find_exact_volume(v);
    CHECK(volume.mantissa == mean.mantissa && volume.exponent == mean.exponent, "%ld: volume %a 2^%d, mean %a 2^%d", n,
          volume.mantissa, volume.exponent, mean.mantissa, mean.exponent);
    CHECK(exact.mantissa == mean.mantissa && exact.exponent == mean.exponent, "%ld: by integers", n);
  }
}

/* The cube's 48 symmetries: vertex v goes where `to[v]` is. */
static void symmetry_of(int number, int to[8]) {
  static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (int v = 0; v < 8; ++v) {
    int image[3];
    for (int axis = 0; axis < 3; ++axis) {
      const int from = orders[number / 8][axis];
      image[axis] = reference_corner[v][from] ^ (number >> axis & 1);
    }
    for (int u = 0; u < 8; ++u)
      if (!memcmp(reference_corner[u], image, sizeof image)) to[v] = u;
  }
}

static bool is_reflection(const int to[8]) {
  double moved[24];
  for (int v = 0; v < 8; ++v) memcpy(moved + 3 * to[v], unit_cube + 3 * v, 3 * sizeof *moved);
  hl_verdict verdict;
  hl_decide(moved, &verdict);
  return verdict != HL_VALID;
}

static hl_report analyzed(const double v[24]) {
  hl_report report;
  CHECK(hl_analyze(v, &report) == HL_OK, "status");
  return report;
}

static void classes_are_what_they_say(void) {
  int counts[5] = {0};
  for (long n = 0; n < TIMES(1500); ++n) {
    double v[24], moved[24];
    int to[8];
    any_hexahedron(n, v);
    for (int i = 0; i < 24; ++i) {
      if (n % 7 == 0 && i % 3 == n / 7 % 3) v[i] = 0.375;
      if (n % 5 == 0 && i % 3 == 0) v[i] = -v[i];
    }
    symmetry_of((int)(n % 48), to);
    for (int i = 0; i < 8; ++i) memcpy(moved + 3 * to[i], v + 3 * i, 3 * sizeof *moved);
    const hl_report one_of_them = analyzed(v), other = analyzed(moved);
    const hl_class c = one_of_them.element_class, d = other.element_class;
    ++counts[c];
    /* A reflection exchanges valid and inverted, nothing else does. */
    const bool is_signed = c == HL_CLASS_VALID || c == HL_CLASS_INVERTED;
    CHECK(is_signed && is_reflection(to) ? d == (c == HL_CLASS_VALID ? HL_CLASS_INVERTED : HL_CLASS_VALID) : d == c,
          "%ld: class %d became %d", n, c, d);
    CHECK((one_of_them.verdict == HL_VALID) == (c == HL_CLASS_VALID), "%ld: class %d of a verdict %d", n, c,
          one_of_them.verdict);
    bool all_zero = true;
    for (int i = 0; i < HL_BERNSTEIN; ++i) all_zero = all_zero && one_of_them.bernstein[i] == 0;
    if (c == HL_CLASS_INVERTED) CHECK(one_of_them.maximizer.value < 0 && one_of_them.volume < 0, "%ld: inverted", n);
    if (one_of_them.is_exact) CHECK((c == HL_CLASS_COLLAPSED) == all_zero, "%ld: collapsed", n);
    CHECK(c != HL_CLASS_COLLAPSED || (isnan(one_of_them.relative_minimum) && one_of_them.is_exact), "%ld: collapsed",
          n);
  }
  for (int i = HL_CLASS_VALID; i <= HL_CLASS_COLLAPSED; ++i)
    CHECK(counts[i] > TIMES(20), "%d of class %d", counts[i], i);
}

static void shapes_are_seen_in_every_numbering(void) {
  static const struct {
    const char *name;
    hl_shape shape;
    int as[8]; /* vertex v is where vertex as[v] is */
  } cases[] = {{"hexahedron", HL_NO_SHAPE, {0, 1, 2, 3, 4, 5, 6, 7}},
               {"wedge", HL_WEDGE, {0, 1, 2, 3, 4, 4, 7, 7}},
               {"pyramid", HL_PYRAMID, {0, 1, 2, 3, 4, 4, 4, 4}},
               {"tetrahedron on a triangle", HL_TETRAHEDRON, {0, 1, 2, 2, 4, 4, 4, 4}},
               {"tetrahedron of five", HL_TETRAHEDRON, {0, 1, 4, 3, 4, 4, 4, 4}},
               {"one edge", HL_NO_SHAPE, {0, 0, 2, 3, 4, 5, 6, 7}},
               {"two edges that are not parallel", HL_NO_SHAPE, {0, 0, 2, 3, 4, 5, 5, 7}},
               {"two opposite edges of the cube", HL_NO_SHAPE, {0, 0, 2, 3, 4, 5, 6, 6}},
               {"a diagonal of a face", HL_NO_SHAPE, {0, 1, 0, 3, 4, 5, 6, 7}},
               {"two diagonals", HL_NO_SHAPE, {0, 1, 0, 3, 4, 5, 4, 7}},
               {"three of a face", HL_NO_SHAPE, {0, 0, 0, 3, 4, 5, 6, 7}},
               {"three edges", HL_NO_SHAPE, {0, 0, 2, 2, 4, 4, 6, 7}},
               {"two faces", HL_NO_SHAPE, {0, 0, 0, 0, 4, 4, 4, 4}},
               {"six at a point", HL_NO_SHAPE, {0, 1, 4, 4, 4, 4, 4, 4}},
               {"a diagonal opposite a face", HL_NO_SHAPE, {0, 1, 0, 3, 4, 4, 4, 4}},
               {"a point", HL_NO_SHAPE, {0, 0, 0, 0, 0, 0, 0, 0}}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i)
    for (int number = 0; number < 48; ++number) {
      int to[8];
      double v[24];
      symmetry_of(number, to);
      for (int u = 0; u < 8; ++u) memcpy(v + 3 * to[u], unit_cube + 3 * cases[i].as[u], 3 * sizeof *v);
      if (number % 5 == 0)
        for (int k = 0; k < 24; ++k) v[k] = v[k] == 0 && k % 2 ? -0.0 : v[k];
      const hl_report report = analyzed(v);
      CHECK(report.shape == cases[i].shape, "%s, symmetry %d: shape %d", cases[i].name, number, report.shape);
      for (int u = 0; u < 8; ++u) {
        int first = 8; /* the least of the moved vertices at the same place */
        for (int x = 0; x < 8; ++x)
          if (cases[i].as[x] == cases[i].as[u] && to[x] < first) first = to[x];
        CHECK(report.coincident[to[u]] == first, "%s, symmetry %d: vertex %d is at that of %d", cases[i].name, number,
              to[u], report.coincident[to[u]]);
      }
      if (cases[i].shape != HL_NO_SHAPE)
        CHECK(report.verdict == HL_INVALID && report.minimizer.value <= 0, "%s is valid", cases[i].name);
    }
}

/* Strictly inside of what it is on, the minimizer among them, the same as from hl_boundary_minimum; roots in order. */
static void candidates_are_in_their_places(void) {
  long exact = 0;
  for (long n = 0; n < TIMES(2400); ++n) {
    double v[24];
    any_hexahedron(n, v);
    hl_report report;
    hl_minimum minimum;
    analyze_exactly(v, &report);
    hl_boundary_minimum(v, HL_ROOTS_B, &minimum);
    bool is_listed = false;
    for (int i = -1; i < report.candidate_count; ++i) {
      const hl_candidate *c = i < 0 ? &report.minimizer : &report.candidates[i];
      for (int axis = 0; axis < 3; ++axis) {
        const bool is_fixed = c->kind == HL_VERTEX || (c->kind == HL_FACE && c->id / 2 == axis) ||
                              (c->kind == HL_EDGE && reference_corner[reference_edge[c->id][0]][axis] ==
                                                         reference_corner[reference_edge[c->id][1]][axis]);
        const double x = c->point[axis];
        const int at = c->kind == HL_VERTEX ? reference_corner[c->id][axis]
                       : c->kind == HL_EDGE ? reference_corner[reference_edge[c->id][0]][axis]
                                            : c->id % 2;
        CHECK(is_fixed ? x == at : x > 0 && x < 1, "%ld: candidate %d, kind %d, id %d at %a", n, i, c->kind, c->id, x);
      }
      CHECK(c->value >= report.minimizer.value, "%ld: candidate %d is below the minimum", n, i);
      is_listed = is_listed || (i >= 0 && !memcmp(c->point, report.minimizer.point, sizeof c->point) &&
                                c->value == report.minimizer.value && c->kind == report.minimizer.kind);
    }
    CHECK(is_listed, "%ld: the minimizer is no candidate", n);
    for (int f = 0; f < HL_FACES; ++f)
      for (int r = 1; r < report.faces[f].root_count; ++r)
        CHECK(report.faces[f].roots[r].t > report.faces[f].roots[r - 1].t, "%ld: face %d: roots", n, f);
    if (!minimum.is_exact) continue;
    ++exact;
    CHECK(!memcmp(minimum.minimizer.point, report.minimizer.point, sizeof report.minimizer.point) &&
              minimum.minimizer.kind == report.minimizer.kind && minimum.minimizer.id == report.minimizer.id,
          "%ld: two minimizers", n);
    int e, f;
    const double x = frexp(minimum.minimizer.value, &e), y = frexp(report.minimizer.value, &f);
    CHECK((x == y && (x == 0 || e + minimum.exponent == f + report.exponent)) ||
              fabs(report.minimizer.value) == DBL_MIN,
          "%ld: two minima", n);
  }
  CHECK(exact > TIMES(200), "%ld exact", exact);
}

int main(void) {
  RUN(wells_have_the_sign_of_their_least_value);
  RUN(touches_on_curved_valleys);
  RUN(triple_roots_are_negative_on_one_side);
  RUN(edges_that_touch_zero_inside);
  RUN(edges_that_are_zero);
  RUN(middles_with_a_double_root);
  RUN(corners_that_are_zero);
  RUN(minima_of_wells_are_found);
  RUN(searches_end_where_the_floor_is_the_minimum);
  RUN(places_of_touching_are_found);
  RUN(volumes_are_the_mean_of_the_coefficients);
  RUN(classes_are_what_they_say);
  RUN(shapes_are_seen_in_every_numbering);
  RUN(candidates_are_in_their_places);
  return test_summary();
}
