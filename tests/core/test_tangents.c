/* The bound by tangents: as a plain evaluation has it, below jacdet, never positive for an invalid element, the same however the
   vertices are numbered, no lower with tangents between the tangents. */
#include "random.h"
#include "reference.h"

#include <string.h>

enum { HEXAHEDRA = 3000, SAMPLES = 50 };

static random_stream stream = {20260506};

/* 2.25 times the coefficients' errors, and the bound's roundings: (K4), with (8) in true units. */
static double bound_error(const double vertices[24]) {
  return (2.25 * 500 + 32 * 18) * UNIT_ROUNDOFF * 8 * edge_product(vertices);
}

static double bound_of(const double vertices[24], int tangents) {
  hl_bound bound = {0, -1};
  CHECK(hl_tangent_bound(vertices, tangents, &bound) == HL_OK && bound.exponent == 0, "status or exponent");
  return bound.value;
}

typedef struct quadratic {
  long double a, b, c;
} quadratic;

static quadratic through(long double at_0, long double at_half, long double at_1) {
  long double a = 2 * (at_0 - 2 * at_half + at_1);
  return (quadratic){a, at_1 - at_0 - a, at_0};
}

/* The greatest of the tangents to x^2, times a, in the place of a x^2. */
static long double below(quadratic q, int tangents, long double x) {
  long double greatest = -HUGE_VALL;
  for (int i = 0; i < tangents; ++i) {
    long double s = tangents == 1 ? 0.5L : (long double)i / (tangents - 1);
    greatest = fmaxl(greatest, 2 * s * x - s * s);
  }
  return q.a * greatest + q.b * x + q.c;
}

static long double least_of(quadratic q) {
  long double least = fminl(q.c, q.a + q.b + q.c), at = q.a > 0 ? -q.b / (2 * q.a) : -1;
  return at > 0 && at < 1 ? fminl(least, q.c + at * (q.b + at * q.a)) : least;
}

/* Points where the tangents meet, and the ends, twice: there the quadratic itself counts, too. */
static int values_below(quadratic q, int tangents, long double values[11]) {
  int count = 0;
  values[count++] = q.c;
  values[count++] = q.a + q.b + q.c;
  values[count++] = below(q, tangents, 0);
  values[count++] = below(q, tangents, 1);
  for (int i = 1; i < tangents; ++i) values[count++] = below(q, tangents, (i - 0.5L) / (tangents - 1));
  return count;
}

static long double plain_bound(const double vertices[24], int tangents) {
  long double best = -HUGE_VALL;
  for (int last = 0; last < 3; ++last) {
    const int first = (last + 1) % 3, second = (last + 2) % 3;
    long double lines[11][11][3], least = HUGE_VALL;
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      long double planes[3][11];
      for (int j = 0; j < 3; ++j) {
        long double samples[3];
        for (int i = 0; i < 3; ++i) {
          double point[3];
          point[first] = 0.5 * i;
          point[second] = 0.5 * j;
          point[last] = 0.5 * k;
          samples[i] = reference_jacdet(vertices, point);
        }
        count = values_below(through(samples[0], samples[1], samples[2]), tangents, planes[j]);
      }
      for (int m = 0; m < count; ++m) {
        long double values[11];
        values_below(through(planes[0][m], planes[1][m], planes[2][m]), tangents, values);
        for (int n = 0; n < count; ++n) lines[m][n][k] = values[n];
      }
    }
    for (int m = 0; m < count; ++m)
      for (int n = 0; n < count; ++n)
        least = fminl(least, least_of(through(lines[m][n][0], lines[m][n][1], lines[m][n][2])));
    best = fmaxl(best, least);
  }
  return best;
}

/* A value that is not certainly positive is at most 0. */
static void check_against_plain(const double vertices[24], int tangents, long number) {
  double value = bound_of(vertices, tangents), error = bound_error(vertices);
  long double plain = plain_bound(vertices, tangents);
  if (value == 0) CHECK(fabsl(plain) <= error, "%ld: 0 by %d tangents, %.17g plainly", number, tangents, (double)plain);
  CHECK(fabsl(value - plain) <= error, "%ld: %.17g by %d tangents, %.17g plainly", number, value, tangents,
        (double)plain);
}

static void is_what_a_plain_evaluation_has(void) {
  for (long n = 0; n < HEXAHEDRA; ++n) {
    double vertices[24];
    random_hexahedron(&stream, 0.05 * (double)(1 + n % 20), vertices);
    check_against_plain(vertices, 1 + (int)(n % 8), n);
  }
}

static void is_below_jacdet_and_certain(void) {
  for (long n = 0; n < HEXAHEDRA; ++n) {
    double vertices[24], error;
    random_hexahedron(&stream, 0.1 + 0.02 * (double)(n % 20), vertices);
    error = bound_error(vertices);
    hl_report report;
    CHECK(hl_analyze(vertices, &report) == HL_OK, "%ld: status", n);
    for (int tangents = 1; tangents <= 8; ++tangents) {
      double value = bound_of(vertices, tangents);
      CHECK(value <= report.volume_minimum.upper + error, "%ld: %.17g is no bound", n, value);
      if (report.verdict == HL_INVALID) CHECK(!(value > 0), "%ld: certifies an invalid element", n);
      /* Another tangent between each two. */
      if (tangents > 1 && 2 * tangents - 1 <= 8)
        CHECK(bound_of(vertices, 2 * tangents - 1) >= value - error, "%ld: more tangents, a lower bound", n);
    }
    CHECK(report.checks[HL_CHECK_TANGENTS] == bound_of(vertices, 4), "%ld: the report has another", n);
    for (int i = 0; i < SAMPLES; ++i) {
      double point[3] = {random_unit(&stream), random_unit(&stream), random_unit(&stream)};
      CHECK(reference_jacdet(vertices, point) >= report.checks[HL_CHECK_TANGENTS] - error, "%ld: jacdet is below", n);
    }
  }
}

/* Elements a few ulps from one whose least jacdet is exactly 0, on an edge and on a face. */
static void is_certain_at_the_border(void) {
  for (long n = 0; n < HEXAHEDRA; ++n) {
    double vertices[24];
    memcpy(vertices, unit_cube, sizeof vertices);
    /* Vertex 6 where jacdet at vertex 5, 2 or 7 is 0, and from there by ulps. */
    const int axis = (int)(n % 3);
    vertices[18 + axis] = 0;
    for (int steps = (int)(n % 7); steps > 0; --steps) vertices[18 + axis] = nextafter(vertices[18 + axis], 1);
    for (int i = 0; i < 24; ++i) vertices[i] += i % 3 == axis ? 0 : 0.01 * random_normal(&stream);
    hl_report report;
    CHECK(hl_analyze(vertices, &report) == HL_OK, "%ld: status", n);
    for (int tangents = 1; tangents <= 8; ++tangents)
      if (report.verdict != HL_VALID) CHECK(!(bound_of(vertices, tangents) > 0), "%ld: certifies what is open", n);
  }
}

static void does_not_depend_on_the_numbering(void) {
  static const int turned[2][8] = {{1, 2, 3, 0, 5, 6, 7, 4}, {3, 2, 6, 7, 0, 1, 5, 4}};
  for (long n = 0; n < HEXAHEDRA; ++n) {
    double vertices[24], other[24];
    random_hexahedron(&stream, 0.02 * (double)(1 + n % 20), vertices);
    for (int v = 0; v < 8; ++v) memcpy(other + 3 * v, vertices + 3 * turned[n % 2][v], 3 * sizeof(double));
    double difference = bound_of(other, 3) - bound_of(vertices, 3);
    CHECK(fabs(difference) <= bound_error(vertices), "%ld: %.3g apart", n, difference);
  }
}

static void is_exact_where_it_can_be(void) {
  for (int tangents = 2; tangents <= 8; ++tangents)
    CHECK(bound_of(unit_cube, tangents) == 1, "the unit cube has %.17g", bound_of(unit_cube, tangents));
  double large[24];
  hl_bound bound;
  for (int i = 0; i < 24; ++i) large[i] = ldexp(unit_cube[i], 900);
  CHECK(hl_tangent_bound(large, 4, &bound) == HL_OK, "status");
  CHECK(ldexp(bound.value, bound.exponent - 2700) == 1, "%.17g * 2^%d", bound.value, bound.exponent);
}

static void refuses_what_it_cannot_answer(void) {
  double vertices[24];
  memcpy(vertices, unit_cube, sizeof vertices);
  hl_bound bound = {7, 7};
  CHECK(hl_tangent_bound(vertices, 0, &bound) == HL_NO_SUCH_RESOLUTION, "0 tangents");
  CHECK(hl_tangent_bound(vertices, 9, &bound) == HL_NO_SUCH_RESOLUTION, "9 tangents");
  vertices[5] = NAN;
  CHECK(hl_tangent_bound(vertices, 4, &bound) == HL_NOT_FINITE, "NaN");
  CHECK(bound.value == 7 && bound.exponent == 7, "the output was written");
}

int main(void) {
  RUN(is_what_a_plain_evaluation_has);
  RUN(is_below_jacdet_and_certain);
  RUN(is_certain_at_the_border);
  RUN(does_not_depend_on_the_numbering);
  RUN(is_exact_where_it_can_be);
  RUN(refuses_what_it_cannot_answer);
  return test_summary();
}
