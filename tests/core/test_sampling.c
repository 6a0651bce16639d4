/* Random elements: no dense sample of the boundary is below the reported minimum beyond rounding, Roots and Roots+B agree
   bit for bit, and the verdict with its early exits agrees with the report. */
#include "random.h"
#include "reference.h"

#include <string.h>

enum { HEXAHEDRA = 3000, GRID = 24 };

/* The reference rounds 2^11 times finer, at most 64 times in a row. */
#define LONG_DOUBLE_ERROR 0x1p-5

static random_stream stream = {20260303};

static void sample_face(const double vertices[24], const hl_report *report, int face, double error, long number) {
  int axis = face / 2, s = axis == 0 ? 1 : 0, t = axis == 2 ? 1 : 2;
  double shift_s = random_unit(&stream), shift_t = random_unit(&stream), point[3];
  point[axis] = face % 2;
  for (int i = 0; i < GRID; ++i)
    for (int j = 0; j < GRID; ++j) {
      point[s] = (i + shift_s) / GRID;
      point[t] = (j + shift_t) / GRID;
      long double jacdet = reference_jacdet(vertices, point);
      CHECK(jacdet >= report->minimizer.value - report->minimum_error - LONG_DOUBLE_ERROR * error,
            "%ld: jacdet %.17g at (%.17g, %.17g, %.17g), minimum %.17g", number, (double)jacdet, point[0], point[1],
            point[2], report->minimizer.value);
      CHECK(jacdet <= report->maximizer.value + error, "%ld: jacdet %.17g above the maximum %.17g", number,
            (double)jacdet, report->maximizer.value);
    }
}

static void dense_samples_are_never_below_the_minimum(void) {
  for (long n = 0; n < HEXAHEDRA; ++n) {
    double vertices[24];
    random_hexahedron(&stream, 0.1 * (double)(1 + n % 20), vertices);
    hl_report report;
    CHECK(hl_analyze(vertices, &report) == HL_OK, "%ld: status", n);
    check_report(vertices, &report, "sampled", n);
    double error = value_error(vertices);
    for (int face = 0; face < 6; ++face) sample_face(vertices, &report, face, error, n);
  }
}

static void the_variants_and_the_queries_agree(void) {
  for (long n = 0; n < 20 * HEXAHEDRA; ++n) {
    double vertices[24];
    random_hexahedron(&stream, 0.1 * (double)(1 + n % 20), vertices);
    hl_report report;
    hl_minimum with, without;
    hl_verdict verdict;
    CHECK(hl_analyze(vertices, &report) == HL_OK && hl_boundary_minimum(vertices, HL_ROOTS, &without) == HL_OK &&
              hl_boundary_minimum(vertices, HL_ROOTS_B, &with) == HL_OK && hl_decide(vertices, &verdict) == HL_OK,
          "%ld: status", n);
    const hl_candidate *minimizers[3] = {&report.minimizer, &without.minimizer, &with.minimizer};
    for (int i = 1; i < 3; ++i)
      CHECK(minimizers[i]->value == minimizers[0]->value && minimizers[i]->kind == minimizers[0]->kind &&
                minimizers[i]->id == minimizers[0]->id &&
                !memcmp(minimizers[i]->point, minimizers[0]->point, sizeof minimizers[i]->point) &&
                !memcmp(minimizers[i]->position, minimizers[0]->position, sizeof minimizers[i]->position),
            "%ld: %.17g against %.17g", n, minimizers[i]->value, minimizers[0]->value);
    CHECK(verdict == report.verdict, "%ld: decide", n);
  }
}

int main(void) {
  RUN(dense_samples_are_never_below_the_minimum);
  RUN(the_variants_and_the_queries_agree);
  return test_summary();
}
