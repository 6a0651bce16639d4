/* One face in integers: what is hard about a search and about its memory. docs/algorithm.md (X3), (X4). */
#include "../../wasm/src/exact_face.h"
#include "check.h"

/* The least memory of exact.c. */
enum { LITTLE = 5000 };

/* Bernstein coefficients of (3x - 1)^2. */
static const int64_t square[3] = {1, -2, 4};

/* f = 2^j ((3s - 1)^2 + (3t - 1)^2) + 1. Its minimum is 1, at (1/3, 1/3). */
static exact_face bowl(workspace *w, int j) {
  exact_face face;
  for (int s = 0; s < 3; ++s)
    for (int t = 0; t < 3; ++t) face.beta[s][t] = integer_of(w, ((square[s] + square[t]) * ((int64_t)1 << j)) + 1);
  return face;
}

static void search_ends(int j) {
  uint32_t limbs[LITTLE];
  workspace w = {.limbs = limbs, .capacity = LITTLE};
  const exact_face face = bowl(&w, j);
  const double roots[1] = {1.0 / 3};
  least_value least = {.numerator = integer_of(&w, ((int64_t)1 << j) + 1), .denominator = integer_of(&w, 1)};
  const bool is_lower = exact_face_lowers(&w, &face, roots, 1, &least);
  CHECK(!w.is_full, "2^%d: the search does not end", j);
  if (w.is_full) return;
  const scaled_double value = rounded_quotient(&w, least.numerator, least.denominator, 0);
  CHECK(is_lower && value.mantissa == 0.5 && value.exponent == 1, "2^%d: %.17g * 2^%d", j, value.mantissa,
        value.exponent);
}

/* The double next to 1/3 is off by 2^-54 / 3: at j = 47 the value there is 1 + 2^-61, and the floor is the minimum itself. */
static void a_floor_may_be_the_minimum(void) {
  for (int j = 40; j <= 55; ++j) search_ends(j);
}

/* An element whose face -zeta is such a bowl: f(1/3, 1/3) is its minimum. */
static void an_element_with_such_a_face(void) {
  const double vertices[HL_COORDINATES] = {48,  96,  -48,
                                           96,  -48, -48,
                                           288, 96,  96,
                                           96,  240, 96,
                                           -96, 96,  -167.99999999997817,
                                           96,  -48, -40.999999999989086,
                                           432, 96,  240,
                                           144, 192, 107.00000000001091};
  hl_minimum minimum;
  CHECK(hl_boundary_minimum(vertices, HL_ROOTS, &minimum) == HL_OK && minimum.is_exact, "integers decide");
  CHECK(minimum.minimizer.kind == HL_FACE && minimum.minimizer.id == 4, "on face %d", minimum.minimizer.id);
  const double error = minimum.minimizer.value / 4.023313522338867e-07 - 1;
  CHECK(error <= 0x1p-51 && error >= -0x1p-51, "%.17g", minimum.minimizer.value);
}

static void a_touching_face_needs_little(void) {
  uint32_t limbs[LITTLE];
  for (int j = 0; j <= 55; ++j) {
    workspace w = {.limbs = limbs, .capacity = LITTLE};
    exact_face face = bowl(&w, j);
    for (int i = 0; i < 9; ++i)
      face.beta[i / 3][i % 3] = integer_difference(&w, face.beta[i / 3][i % 3], integer_of(&w, 1));
    CHECK(exact_face_sign(&w, &face) == 0 && !w.is_full, "2^%d: it touches zero", j);
  }
}

int main(void) {
  RUN(a_touching_face_needs_little);
  RUN(a_floor_may_be_the_minimum);
  RUN(an_element_with_such_a_face);
  return test_summary();
}
