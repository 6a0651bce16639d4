/* Laws of the core on single elements: known elements, scaling, translation, symmetry, refusals, the sizes of the doubles. */
#include "random.h"
#include "reference.h"

#include <string.h>

static random_stream stream = {20260202};

static const double paper_counterexample[24] = {0, 0, 0, 1, 0, 0, 0,  0,  0,  0, 1, 0,
                                                0, 0, 1, 0, 0, 0, -1, -1, -1, 0, 0, 0};

static hl_report analyzed(const double vertices[24]) {
  hl_report report;
  memset(&report, 0, sizeof report);
  hl_status status = hl_analyze(vertices, &report);
  CHECK(status == HL_OK, "status %d", (int)status);
  return report;
}

static void unit_cube_is_one_everywhere(void) {
  hl_report report = analyzed(unit_cube);
  check_report(unit_cube, &report, "cube", 0);
  CHECK(report.verdict == HL_VALID && report.minimizer.value == 1 && report.maximizer.value == 1, "jacdet is not 1");
  for (int i = 0; i < 27; ++i) CHECK(report.bernstein[i] == 1, "coefficient %d is %g", i, report.bernstein[i]);
  CHECK(report.candidate_count == 8, "%d candidates", report.candidate_count);
  for (int f = 0; f < 6; ++f)
    CHECK(report.faces[f].skipped_by_minimum_rule && report.faces[f].skipped_by_validity_rule &&
              report.faces[f].quartic_is_zero,
          "face %d", f);
}

static void paper_counterexample_has_boundary_minimum_zero(void) {
  hl_report report = analyzed(paper_counterexample);
  CHECK(report.verdict == HL_INVALID && report.minimizer.value == 0, "minimum %g", report.minimizer.value);
  const double centre[3] = {0.5, 0.5, 0.5};
  hl_jacobian jacobian;
  CHECK(hl_jacobian_at(paper_counterexample, centre, &jacobian) == HL_OK && jacobian.jacdet == -0.25, "centre %g",
        jacobian.jacdet);
}

/* Bernstein form, DF's columns and the definition agree inside the cube; the columns are differences of F. */
static void bernstein_form_is_jacdet(void) {
  for (long n = 0; n < TIMES(2000); ++n) {
    double vertices[24];
    random_hexahedron(&stream, 0.1 + random_unit(&stream), vertices);
    hl_report report = analyzed(vertices);
    check_report(vertices, &report, "random", n);
    double point[3] = {random_unit(&stream), random_unit(&stream), random_unit(&stream)}, sum = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) {
          int at[3] = {i, j, k};
          double weight = 1;
          for (int axis = 0; axis < 3; ++axis) {
            double x = point[axis], basis[3] = {(1 - x) * (1 - x), 2 * x * (1 - x), x * x};
            weight *= basis[at[axis]];
          }
          sum += weight * report.bernstein[9 * i + 3 * j + k];
        }
    /* value_error is 431 u in scaled units. The cube's centre is off by at most 461 u, (12 * 55 + 8 * 49) / 4 from its terms
       and 198 from their sums; coefficients are at most 30, and the weights and 27 terms add less than 35 * 30 u. */
    double exact = (double)reference_jacdet(vertices, point), error = 5 * value_error(vertices);
    hl_jacobian jacobian;
    CHECK(hl_jacobian_at(vertices, point, &jacobian) == HL_OK, "status");
    CHECK(fabs(sum - exact) <= error, "%ld: Bernstein form %.17g, jacdet %.17g", n, sum, exact);
    CHECK(fabs(jacobian.jacdet - exact) <= error, "%ld: det DF %.17g, jacdet %.17g", n, jacobian.jacdet, exact);

    double low[3] = {point[0], 0, point[2]}, high[3] = {point[0], 1, point[2]};
    hl_jacobian at_low, at_high;
    hl_jacobian_at(vertices, low, &at_low);
    hl_jacobian_at(vertices, high, &at_high);
    /* Each of the three is off by at most nine roundings of the vertices' size, three levels of three. */
    double size = 0;
    for (int i = 0; i < 24; ++i) size = fmax(size, fabs(vertices[i]));
    for (int r = 0; r < 3; ++r)
      CHECK(fabs(at_high.position[r] - at_low.position[r] - jacobian.columns[1][r]) <=
                (9 + 9 + 18 + 3) * UNIT_ROUNDOFF * size,
            "%ld: the column dF/deta is not the difference of F", n);
  }
}

/* P by its definition 4a^2c' - 2abb' + a'b^2 from the powers of s and t, against the reported Bernstein form. */
static void quartic_is_its_definition(void) {
  for (long n = 0; n < TIMES(2000); ++n) {
    double vertices[24];
    random_hexahedron(&stream, 0.1 + random_unit(&stream), vertices);
    hl_report report = analyzed(vertices);
    for (int f = 0; f < 6; ++f) {
      const double *beta = report.faces[f].bernstein;
      long double power[3][3], t = random_unit(&stream); /* power[m]: coefficients in t of the factor of s^m */
      for (int j = 0; j < 3; ++j) {
        power[0][j] = beta[j];
        power[1][j] = 2 * ((long double)beta[3 + j] - beta[j]);
        power[2][j] = (long double)beta[j] - 2 * (long double)beta[3 + j] + beta[6 + j];
      }
      long double value[3], slope[3], size = 0;
      for (int m = 0; m < 3; ++m) {
        long double *q = power[m];
        value[m] = q[0] * (1 - t) * (1 - t) + 2 * q[1] * t * (1 - t) + q[2] * t * t;
        slope[m] = 2 * ((q[1] - q[0]) * (1 - t) + (q[2] - q[1]) * t);
        for (int j = 0; j < 3; ++j) size = fmaxl(size, fabsl(q[j]));
      }
      long double b = value[1], a = value[2];
      long double exact = 4 * a * a * slope[0] - 2 * a * b * slope[1] + slope[2] * b * b;
      const double *p = report.faces[f].quartic;
      long double s = 1 - t, computed = p[0] * s * s * s * s + 4 * p[1] * s * s * s * t + 6 * p[2] * s * s * t * t +
                                        4 * p[3] * s * t * t * t + p[4] * t * t * t * t;
      CHECK(report.faces[f].quartic_exponent == 0, "%ld: exponent", n);
      /* The terms of P are at most 28 size^3, with 32 u of rounding (17) 896 u at worst; 200 u are enough here. */
      CHECK(fabsl(computed - exact) <= 200 * UNIT_ROUNDOFF * size * size * size,
            "%ld face %d: P(%.17g) is %.17Lg, not %.17Lg", n, f, (double)t, exact, computed);
    }
  }
}

static void scaling_by_powers_of_two_is_exact(void) {
  for (long n = 0; n < TIMES(500); ++n) {
    double vertices[24], scaled[24];
    random_hexahedron(&stream, 0.5, vertices);
    hl_report report = analyzed(vertices);
    for (int exponent = -300; exponent <= 300; exponent += 60) {
      for (int i = 0; i < 24; ++i) scaled[i] = ldexp(vertices[i], exponent);
      hl_report other = analyzed(scaled);
      CHECK(other.exponent == 0 && other.minimizer.value == ldexp(report.minimizer.value, 3 * exponent),
            "%ld: 2^%d changes the minimum", n, exponent);
      CHECK(!memcmp(other.minimizer.point, report.minimizer.point, sizeof report.minimizer.point), "%ld: place", n);
    }
  }
}

/* One axis a millionth or a million times the others: jacdet scales by the product, exactly. */
static void scaling_of_one_axis_is_exact(void) {
  for (long n = 0; n < TIMES(500); ++n) {
    double vertices[24], scaled[24];
    random_hexahedron(&stream, 0.5, vertices);
    hl_report report = analyzed(vertices);
    for (int i = 0; i < 24; ++i) scaled[i] = ldexp(vertices[i], i % 3 == 0 ? -530 : i % 3 == 1 ? 530 : 3);
    hl_report other = analyzed(scaled);
    CHECK(other.exponent == 0 && other.minimizer.value == 8 * report.minimizer.value, "%ld", n);
  }
}

/* Sizes whose jacdet no double holds: mantissa and exponent carry it, and nothing else changes. */
static void sizes_beyond_the_doubles(void) {
  for (long n = 0; n < TIMES(200); ++n) {
    double vertices[24], scaled[24];
    random_hexahedron(&stream, 0.3, vertices);
    hl_report report = analyzed(vertices);
    for (int size = -1000; size <= 1000; size += 2000) {
      for (int i = 0; i < 24; ++i) scaled[i] = ldexp(vertices[i], size);
      hl_report other = analyzed(scaled);
      CHECK(other.exponent != 0 && other.verdict == report.verdict, "%ld: 2^%d", n, size);
      CHECK(ldexp(other.minimizer.value, other.exponent - 3 * size) == report.minimizer.value, "%ld: 2^%d", n, size);
    }
  }
  double subnormal[24], huge[24];
  for (int i = 0; i < 24; ++i) {
    subnormal[i] = unit_cube[i] * 0x1p-1074;
    huge[i] = unit_cube[i] != 0 ? 0x1.fffffffffffffp1023 : -0x1.fffffffffffffp1023;
  }
  hl_report small = analyzed(subnormal), large = analyzed(huge);
  CHECK(small.verdict == HL_VALID && ldexp(small.minimizer.value, small.exponent + 3222) == 1, "the least doubles");
  CHECK(large.verdict == HL_VALID && ldexp(large.minimizer.value, large.exponent - 3072) == pow(0x1.fffffffffffffp0, 3),
        "the greatest doubles: %.17g 2^%d", large.minimizer.value, large.exponent);
}

static void translation_changes_nothing(void) {
  for (long n = 0; n < TIMES(500); ++n) {
    double vertices[24], moved[24];
    for (int i = 0; i < 24; ++i) vertices[i] = unit_cube[i] + floor(256 * random_normal(&stream)) / 1024;
    for (int i = 0; i < 24; ++i) moved[i] = vertices[i] + (double)(1 << 20) * (i % 3 - 1);
    hl_report report = analyzed(vertices), other = analyzed(moved);
    CHECK(report.candidate_count == other.candidate_count, "%ld: candidates", n);
    for (int i = 0; i < report.candidate_count; ++i)
      CHECK(report.candidates[i].value == other.candidates[i].value, "%ld: candidate %d", n, i);
    for (int i = 0; i < 27; ++i) CHECK(report.bernstein[i] == other.bernstein[i], "%ld: coefficient %d", n, i);
  }
}

/* The 48 symmetries of the cube: relabelled by a rotation the minimum stays, by a reflection jacdet is negated. */
static void symmetries_of_the_cube(void) {
  static const int permutations[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
  for (long n = 0; n < TIMES(300); ++n) {
    double vertices[24], relabelled[24];
    random_hexahedron(&stream, 0.4, vertices);
    hl_report report = analyzed(vertices);
    double error = 2 * value_error(vertices);
    for (int p = 0; p < 6; ++p)
      for (int flips = 0; flips < 8; ++flips) {
        for (int v = 0; v < 8; ++v) {
          int corner[3], target = 0;
          for (int axis = 0; axis < 3; ++axis)
            corner[axis] = reference_corner[v][permutations[p][axis]] ^ (flips >> axis & 1);
          while (memcmp(reference_corner[target], corner, sizeof corner)) ++target;
          memcpy(relabelled + 3 * v, vertices + 3 * target, 3 * sizeof(double));
        }
        bool reflected = (p >= 3) != ((flips & 1) != ((flips >> 1 & 1) != (flips >> 2 & 1)));
        hl_report other = analyzed(relabelled);
        double expected = reflected ? -report.maximizer.value : report.minimizer.value;
        CHECK(fabs(other.minimizer.value - expected) <= error, "%ld: symmetry %d %d", n, p, flips);
      }
  }
}

static void refusals(void) {
  hl_report report;
  hl_minimum minimum;
  hl_jacobian jacobian;
  hl_verdict verdict = HL_VALID;
  const double inside[3] = {0.5, 0.5, 0.5};
  const double bad[3] = {NAN, INFINITY, -INFINITY};
  for (int i = 0; i < 24; ++i)
    for (int b = 0; b < 3; ++b) {
      double vertices[24];
      memcpy(vertices, unit_cube, sizeof vertices);
      vertices[i] = bad[b];
      memset(&report, 0x5a, sizeof report);
      hl_report untouched = report;
      CHECK(hl_analyze(vertices, &report) == HL_NOT_FINITE && !memcmp(&report, &untouched, sizeof report), "analyze %d",
            i);
      CHECK(hl_boundary_minimum(vertices, HL_ROOTS, &minimum) == HL_NOT_FINITE, "minimum %d", i);
      CHECK(hl_decide(vertices, &verdict) == HL_NOT_FINITE && verdict == HL_VALID, "decide %d", i);
      CHECK(hl_jacobian_at(vertices, inside, &jacobian) == HL_NOT_FINITE, "jacobian %d", i);
    }
  const double outside[3] = {0.5, 1.0000001, 0.5}, not_a_point[3] = {0.5, NAN, 0.5};
  CHECK(hl_jacobian_at(unit_cube, outside, &jacobian) == HL_OUTSIDE_CUBE, "outside");
  CHECK(hl_jacobian_at(unit_cube, not_a_point, &jacobian) == HL_NOT_FINITE, "not a point");
}

/* Collapsed elements: no exception, a minimum of exactly zero, and no minus zero anywhere. */
static void collapsed_elements(void) {
  double point[24] = {0}, line[24] = {0}, plane[24];
  for (int v = 0; v < 8; ++v) {
    line[3 * v] = v;
    for (int r = 0; r < 3; ++r) plane[3 * v + r] = r == 2 ? 0 : unit_cube[3 * v + r] + 0.25 * v * r;
  }
  const double *elements[3] = {point, line, plane};
  for (int i = 0; i < 3; ++i) {
    hl_report report = analyzed(elements[i]);
    CHECK(report.verdict == HL_INVALID && report.minimizer.value == 0 && !signbit(report.minimizer.value), "element %d",
          i);
    CHECK(report.is_exact && report.element_class == HL_CLASS_COLLAPSED && report.volume == 0 &&
              isnan(report.relative_minimum),
          "element %d: class %d", i, report.element_class);
    for (int b = 0; b < 27; ++b) CHECK(report.bernstein[b] == 0 && !signbit(report.bernstein[b]), "element %d", i);
  }
}

/* Coordinates from -2 to 2: collapsed edges, flat faces, P of any degree or 0, multiple roots, ties. */
static void small_integers(void) {
  for (long n = 0; n < TIMES(50000); ++n) {
    double vertices[24];
    for (int i = 0; i < 24; ++i) vertices[i] = (double)(random_bits(&stream) % 5) - 2;
    hl_report report = analyzed(vertices);
    check_report(vertices, &report, "integers", n);
  }
}

/* Doubles with any bits: a status, or finite numbers and no minus zero; never a hang. Meant for the sanitizers. */
static void any_bits(void) {
  for (long n = 0; n < TIMES(3000); ++n) {
    double vertices[24];
    for (int i = 0; i < 24; ++i) {
      uint64_t bits = random_bits(&stream);
      memcpy(&vertices[i], &bits, sizeof bits);
      if (n % 2) vertices[i] = ldexp(vertices[i], -(int)(bits % 1500));
      if (n % 3 == 0 && bits % 4 == 0) vertices[i] = 0;
    }
    hl_report report;
    if (hl_analyze(vertices, &report) != HL_OK) continue;
    double packed[HL_PACKED_REPORT];
    size_t length = hl_pack_report(&report, packed);
    CHECK(length <= HL_PACKED_REPORT, "%ld: packed length %zu", n, length);
    for (size_t i = 0; i < length; ++i)
      CHECK(isfinite(packed[i]) && !(packed[i] == 0 && signbit(packed[i])), "%ld: packed number %zu is %g", n, i,
            packed[i]);
    hl_verdict verdict;
    hl_minimum with, without;
    CHECK(hl_decide(vertices, &verdict) == HL_OK && verdict == report.verdict, "%ld: decide", n);
    hl_boundary_minimum(vertices, HL_ROOTS, &without);
    hl_boundary_minimum(vertices, HL_ROOTS_B, &with);
    CHECK(!memcmp(&with.minimizer.value, &without.minimizer.value, sizeof(double)), "%ld: Roots and Roots+B", n);
  }
}

int main(void) {
  RUN(unit_cube_is_one_everywhere);
  RUN(paper_counterexample_has_boundary_minimum_zero);
  RUN(bernstein_form_is_jacdet);
  RUN(quartic_is_its_definition);
  RUN(scaling_by_powers_of_two_is_exact);
  RUN(scaling_of_one_axis_is_exact);
  RUN(sizes_beyond_the_doubles);
  RUN(translation_changes_nothing);
  RUN(symmetries_of_the_cube);
  RUN(refusals);
  RUN(collapsed_elements);
  RUN(small_integers);
  RUN(any_bits);
  return test_summary();
}
