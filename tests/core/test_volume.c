/* The minimum inside: no sample of the closed element is below its bracket, the place holds the upper end, the bracket is as
   narrow as promised, and flat valleys end; the checks of other programs against plain evaluation. */
#include "../../wasm/src/volume.h"
#include "random.h"
#include "reference.h"

#include <string.h>

enum { HEXAHEDRA = 4000, SAMPLES = 200 };

static random_stream stream = {20260404};

/* upper - lower <= 3.1e-11 of the largest coefficient: docs/algorithm.md 8. */
#define WIDTH 3.1e-11

static double largest_coefficient(const double bernstein[27]) {
  double largest = 0;
  for (int i = 0; i < 27; ++i) largest = fmax(largest, fabs(bernstein[i]));
  return largest;
}

static void check_bracket(const double vertices[24], const hl_report *report, double sampling_error, long number) {
  const hl_volume_minimum *v = &report->volume_minimum;
  CHECK(v->lower <= v->upper, "%ld: bracket upside down", number);
  CHECK(v->lower <= report->minimizer.value + report->minimum_error, "%ld: above the boundary minimum", number);
  CHECK(v->upper - v->lower <= WIDTH * largest_coefficient(report->bernstein), "%ld: %.3g wide", number,
        v->upper - v->lower);
  long double there = reference_jacdet(vertices, v->point);
  CHECK(there <= v->upper + sampling_error, "%ld: %.17g at the place, upper %.17g", number, (double)there, v->upper);
  for (int i = 0; i < SAMPLES; ++i) {
    /* Half of them near the place, where one below would be. */
    double point[3];
    for (int axis = 0; axis < 3; ++axis) {
      double x = i % 2 ? random_unit(&stream) : v->point[axis] + 0.01 * random_normal(&stream);
      point[axis] = fmin(fmax(x, 0), 1);
    }
    long double jacdet = reference_jacdet(vertices, point);
    CHECK(jacdet >= v->lower - sampling_error, "%ld: %.17g below %.17g", number, (double)jacdet, v->lower);
  }
}

static void random_elements_stay_in_their_brackets(void) {
  long below_the_boundary = 0;
  for (long n = 0; n < HEXAHEDRA; ++n) {
    double vertices[24];
    random_hexahedron(&stream, 0.1 * (double)(1 + n % 20), vertices);
    if (n % 4 == 3)
      for (int i = 0; i < 24; ++i) vertices[i] = round(2 * vertices[i]);
    hl_report report;
    CHECK(hl_analyze(vertices, &report) == HL_OK, "%ld: status", n);
    check_bracket(vertices, &report, value_error(vertices) * 0x1p-5, n);
    if (report.volume_minimum.upper < report.minimizer.value - report.minimum_error) ++below_the_boundary;
  }
  CHECK(below_the_boundary > 0, "no element was lower inside");
}

/* Bernstein coefficients of a sum of products of quadratics, from its values at the 27 points with coordinates 0, 1/2, 1. */
static void coefficients_of(double (*f)(const double point[3]), double bernstein[27]) {
  double largest = 0;
  for (int i = 0; i < 27; ++i) {
    const double point[3] = {0.5 * (i / 9), 0.5 * (i / 3 % 3), 0.5 * (i % 3)};
    bernstein[i] = f(point);
  }
  static const int strides[3] = {9, 3, 1};
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 27; ++i) {
      int s = strides[axis];
      if (i / s % 3 == 1) bernstein[i] = 2 * bernstein[i] - 0.5 * (bernstein[i - s] + bernstein[i + s]);
    }
  for (int i = 0; i < 27; ++i) largest = fmax(largest, fabs(bernstein[i]));
  for (int i = 0; i < 27; ++i) bernstein[i] /= largest;
}

/* Flat along tilted planes, along a curve, along an axis; a saddle; a minimum at a dyadic point inside. */
static double tilted_plane(const double p[3]) { return pow(p[0] + p[1] - 0.9, 2) - 0.25; }
static double curved_valley(const double p[3]) {
  return pow(p[0] - 0.3 * p[1] - 0.2, 2) + pow(p[2] - 0.7 * p[1], 2) - 0.1;
}
static double along_an_axis(const double p[3]) { return pow(p[0] - 1.0 / 3, 2) + p[1] * (1 - p[1]) - 0.3; }
static double saddle(const double p[3]) { return (p[0] - 0.4) * (p[1] - 0.6) - (p[2] - 0.5) * (p[0] - 0.5); }
static double well(const double p[3]) {
  return pow(p[0] - 0.5, 2) + pow(p[1] - 0.25, 2) + 2 * pow(p[2] - 0.5, 2) + (p[0] - 0.5) * (p[1] - 0.25) - 0.5;
}
static double constant(const double p[3]) { return -1 + 0 * p[0]; }

static void valleys_and_wells_end(void) {
  double (*const functions[])(const double[3]) = {tilted_plane, curved_valley, along_an_axis, saddle, well, constant};
  for (int n = 0; n < 6; ++n) {
    double bernstein[27];
    coefficients_of(functions[n], bernstein);
    const hl_candidate start = {.value = bernstein[0]};
    const hl_volume_minimum bracket = bracketed_volume_minimum(bernstein, 0x1p-53, &start), *v = &bracket;
    CHECK(v->upper - v->lower <= WIDTH, "%d: %.3g wide", n, v->upper - v->lower);
    double scale = bernstein[0] != 0 ? functions[n]((const double[3]){0, 0, 0}) / bernstein[0] : 1;
    for (int i = 0; i < 100 * SAMPLES; ++i) {
      const double point[3] = {random_unit(&stream), random_unit(&stream), random_unit(&stream)};
      CHECK(functions[n](point) / scale >= v->lower - 1e-14, "%d: below", n);
    }
    CHECK(fabs(functions[n](v->point) / scale - v->upper) <= WIDTH, "%d: place", n);
  }
}

static double least_of_grid(const double vertices[24], const double *points, int count) {
  long double least = HUGE_VALL;
  for (int i = 0; i < count * count * count; ++i)
    least = fminl(least, reference_jacdet(vertices, (const double[3]){points[i / count / count],
                                                                      points[i / count % count], points[i % count]}));
  return (double)least;
}

static long double reference_scaled_jacobian(const double vertices[24], const double point[3]) {
  long double lengths = 1;
  for (int axis = 0; axis < 3; ++axis) {
    long double square = 0;
    for (int r = 0; r < 3; ++r) {
      long double component = 0;
      for (int v = 0; v < 8; ++v) {
        long double weight = reference_corner[v][axis] ? 1 : -1;
        for (int other = 0; other < 3; ++other)
          if (other != axis) weight *= reference_corner[v][other] ? point[other] : 1 - point[other];
        component += weight * vertices[3 * v + r];
      }
      square += component * component;
    }
    lengths *= sqrtl(square);
  }
  return reference_jacdet(vertices, point) / lengths;
}

static void checks_agree_with_plain_evaluation(void) {
  const double two[2] = {0.5 - sqrt(3) / 6, 0.5 + sqrt(3) / 6};
  const double three[3] = {0.5 - sqrt(15) / 10, 0.5, 0.5 + sqrt(15) / 10};
  for (long n = 0; n < HEXAHEDRA; ++n) {
    double vertices[24];
    random_hexahedron(&stream, 0.05 * (double)(1 + n % 20), vertices);
    for (int i = 0; i < 24; ++i) vertices[i] *= i % 3 == 0 ? 0x1p40 : 1; /* one axis far larger than the others */
    hl_report report;
    CHECK(hl_analyze(vertices, &report) == HL_OK, "%ld: status", n);
    double error = value_error(vertices);
    CHECK(fabs(report.checks[HL_CHECK_GAUSS_2] - least_of_grid(vertices, two, 2)) <= error, "%ld: 2x2x2", n);
    CHECK(fabs(report.checks[HL_CHECK_GAUSS_3] - least_of_grid(vertices, three, 3)) <= error, "%ld: 3x3x3", n);
    long double scaled = reference_scaled_jacobian(vertices, (const double[3]){0.5, 0.5, 0.5});
    for (int v = 0; v < 8; ++v) {
      const int *r = reference_corner[v];
      scaled = fminl(scaled, reference_scaled_jacobian(vertices, (const double[3]){r[0], r[1], r[2]}));
    }
    CHECK(fabsl(report.scaled_jacobian - scaled) <= 1e-13, "%ld: scaled Jacobian", n);
    CHECK(report.checks[HL_CHECK_CORNERS] == report.corner_minimum, "%ld: corners", n);
    CHECK(report.checks[HL_CHECK_EDGES] == report.edge_minimum, "%ld: edges", n);
    CHECK(report.checks[HL_CHECK_BERNSTEIN] <= report.volume_minimum.upper, "%ld: a bound above the minimum", n);
    /* Accepted only by bounds: never an invalid element. */
    if (report.verdict == HL_INVALID) CHECK(!(report.checks[HL_CHECK_SUBDIVISION] > 0), "%ld: subdivision", n);
  }
}

int main(void) {
  RUN(random_elements_stay_in_their_brackets);
  RUN(valleys_and_wells_end);
  RUN(checks_agree_with_plain_evaluation);
  return test_summary();
}
