/* Faces whose quartic is hard: hexahedra made so that face -zeta has a prescribed polynomial. That no point of the face is
   below the reported minimum is proved by subdividing its Bernstein form, not sampled. */
#include "../../wasm/src/bernstein.h"
#include "../../wasm/src/candidates.h"
#include "../../wasm/src/face.h"
#include "../../wasm/src/filter.h"
#include "random.h"
#include "reference.h"

static random_stream stream = {20260606};

enum { HARD_FACE = 4 };

typedef struct patch {
  long double b[9]; /* [3*i + j], i in s, j in t */
} patch;

static void halve(const long double *q, int stride, long double *lower, long double *upper) {
  long double first = (q[0] + q[stride]) / 2, last = (q[stride] + q[2 * stride]) / 2, start = q[0], end = q[2 * stride];
  lower[0] = start;
  lower[stride] = first;
  lower[2 * stride] = upper[0] = (first + last) / 2;
  upper[stride] = last;
  upper[2 * stride] = end;
}

/* No value of the patch is below `bound`: its least coefficient is not, or neither half has such a value; the cut is across
   the direction of more variation. */
static bool is_at_least(const patch *p, long double bound, int depth) {
  long double least = p->b[0], variation[2] = {0, 0};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      least = fminl(least, p->b[3 * i + j]);
      if (i > 0) variation[0] = fmaxl(variation[0], fabsl(p->b[3 * i + j] - p->b[3 * i + j - 3]));
      if (j > 0) variation[1] = fmaxl(variation[1], fabsl(p->b[3 * i + j] - p->b[3 * i + j - 1]));
    }
  if (least >= bound) return true;
  if (depth == 0 || p->b[0] < bound || p->b[2] < bound || p->b[6] < bound || p->b[8] < bound) return false;
  bool across_s = variation[0] > variation[1];
  patch lower, upper;
  for (int i = 0; i < 3; ++i) {
    int start = across_s ? i : 3 * i;
    halve(p->b + start, across_s ? 3 : 1, lower.b + start, upper.b + start);
  }
  return is_at_least(&lower, bound, depth - 1) && is_at_least(&upper, bound, depth - 1);
}

/* The hexahedron whose face -zeta has f = sum of power[i][j] s^i t^j, power[2][2] = 0. With U_00 = e1, V_00 = e2 and
   p_110 = e1 + e2 + e3 it is f = W_z - s W_y - t W_x, where W is bilinear and free. */
static void hexahedron_of_face(double power[3][3], double vertices[24]) {
  static const int low[4] = {0, 1, 3, 2}, high[4] = {4, 5, 7, 6};
  for (int corner = 0; corner < 4; ++corner) {
    double s = corner & 1, t = corner >> 1;
    double base[3] = {s, t, s * t};
    double w[3] = {-(power[0][2] * t + power[1][2] * s * t), -(power[2][0] * s + power[2][1] * s * t),
                   power[0][0] + power[1][0] * s + power[0][1] * t + power[1][1] * s * t};
    for (int r = 0; r < 3; ++r) {
      vertices[3 * low[corner] + r] = base[r];
      vertices[3 * high[corner] + r] = base[r] + w[r];
    }
  }
}

static double least_on_face(const hl_report *report) {
  double least = INFINITY;
  for (int i = 0; i < report->candidate_count; ++i) {
    const hl_candidate *c = &report->candidates[i];
    if (c->point[2] == 0) least = fmin(least, c->value);
  }
  return least;
}

static void check_hard_face(const double vertices[24], const char *what, long number) {
  hl_report report;
  CHECK(hl_analyze(vertices, &report) == HL_OK, "%s %ld: status", what, number);
  const double *beta = report.faces[HARD_FACE].bernstein;
  patch face;
  double greatest = 0;
  for (int i = 0; i < 9; ++i) {
    face.b[i] = beta[i];
    greatest = fmax(greatest, fabs(beta[i]));
  }
  /* docs/algorithm.md 4 allows 4000 u of the largest coefficient, a worst case; 2 to 4 u is the most that was seen. */
  double error = 16 * UNIT_ROUNDOFF * greatest, least = least_on_face(&report);
  CHECK(is_at_least(&face, least - error, 120), "%s %ld: the face is below %.17g by more than %.3g", what, number,
        least, error);
}

/* A shallow valley: a and B of size e where the minimum is, up to 1 elsewhere, as a = a0 + a1 x, B = B0 + B1 x + B2 x^2,
   c = c1 x + c2 x^2 with x = t - t0. P is of size e^2 and less there, below the rounding errors of P on [0,1]. */
static void shallow_valleys(void) {
  for (long n = 0; n < TIMES(20000); ++n) {
    double e = pow(10, -2 - 14 * random_unit(&stream)), slope = n % 2 ? sqrt(e) : e;
    double t0 = 0.1 + 0.8 * random_unit(&stream), s0 = 0.2 + 0.6 * random_unit(&stream);
    double a0 = e * (0.5 + random_unit(&stream)), a1 = slope * random_normal(&stream);
    double b0 = -a0 * s0, b1 = slope * random_normal(&stream),
           b2 = fabs(random_normal(&stream)) * (n % 4 < 2 ? 1 : sqrt(e));
    double c1 = -(2 * b1 * s0 + a1 * s0 * s0), c2 = pow(10, -2 * random_unit(&stream));
    double power[3][3] = {{c2 * t0 * t0 - c1 * t0, c1 - 2 * c2 * t0, c2},
                          {2 * (b0 - b1 * t0 + b2 * t0 * t0), 2 * (b1 - 2 * b2 * t0), 2 * b2},
                          {a0 - a1 * t0, a1, 0}},
           vertices[24];
    hexahedron_of_face(power, vertices);
    check_hard_face(vertices, "valley", n);
  }
}

/* Coefficients of very different sizes, many of them 0: P of any degree, identically zero, a or b zero or of either sign. */
static void random_polynomials(void) {
  for (long n = 0; n < TIMES(20000); ++n) {
    double power[3][3] = {{0}}, vertices[24];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3 - (i == 2); ++j)
        if (random_bits(&stream) % 4)
          power[i][j] = random_normal(&stream) * (random_bits(&stream) % 2 ? 1 : pow(10, -18 * random_unit(&stream)));
    hexahedron_of_face(power, vertices);
    check_hard_face(vertices, "polynomial", n);
  }
}

/* f = (s - s0)^2 a(t) + c(t): the minimum lies where a touches or nearly touches 0, near an end of the face or inside. */
static void squares(void) {
  for (long n = 0; n < TIMES(20000); ++n) {
    double s0 = random_unit(&stream), zero = n % 2 ? -pow(10, -16 * random_unit(&stream)) : random_unit(&stream);
    double a1 = n % 4 < 2 ? 1 : -1, a0 = -a1 * zero, t0 = random_unit(&stream) * (n % 3 ? 1 : 1e-6);
    double c2 = pow(10, -16 * random_unit(&stream)), b1 = 1e-3 * random_normal(&stream) * c2;
    double power[3][3] = {{c2 * t0 * t0 + s0 * s0 * a0, -2 * c2 * t0 + s0 * s0 * a1, c2},
                          {-2 * s0 * a0, -2 * s0 * a1 + b1, 0},
                          {a0, a1, 0}},
           vertices[24];
    hexahedron_of_face(power, vertices);
    check_hard_face(vertices, "square", n);
  }
}

/* The W of face -zeta is tiny beside the other edges, in components where the face's vertices are 0, so that it stays exact.
   The face is then that of W * 2^-20 times a power of two, bit for bit, down to where cubes of it leave the doubles. */
static void tiny_faces_scale_exactly(void) {
  static const double base[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 1, 0}}; /* vertices 0 to 3 */
  long kept = 0;
  for (long n = 0; n < TIMES(2000); ++n) {
    double w[4][3];
    for (int v = 0; v < 4; ++v)
      for (int r = 0; r < 3; ++r) w[v][r] = base[v][r] == 0 ? random_normal(&stream) : 0;
    static const int exponents[3] = {-20, -400, -900};
    face_solution solutions[3];
    double beta[3][HL_FACE_BERNSTEIN];
    for (int size = 0; size < 3; ++size) {
      double vertices[24], bernstein[HL_BERNSTEIN];
      edge_vectors edges;
      for (int v = 0; v < 4; ++v)
        for (int r = 0; r < 3; ++r) {
          vertices[3 * v + r] = base[v][r];
          vertices[3 * (v + 4) + r] = base[v][r] + ldexp(w[v][r], exponents[size]);
        }
      scaled_edge_vectors(vertices, &edges);
      jacdet_bernstein(&edges, bernstein);
      face_bernstein(bernstein, HARD_FACE, beta[size]);
      solve_face(beta[size], &solutions[size]);
      const face_solution *face = &solutions[size], *first = &solutions[0];
      int shift = exponents[size] - exponents[0];
      for (int i = 0; i < 9; ++i) CHECK(beta[size][i] == ldexp(beta[0][i], shift), "%ld: coefficient %d", n, i);
      CHECK(face->root_count == first->root_count, "%ld: %d roots, not %d", n, face->root_count, first->root_count);
      for (int r = 0; r < face->root_count; ++r) {
        CHECK(face->roots[r].t == first->roots[r].t && face->roots[r].s == first->roots[r].s &&
                  face->roots[r].fate == first->roots[r].fate && face->roots[r].a == ldexp(first->roots[r].a, shift),
              "%ld: root %d", n, r);
        if (face->roots[r].fate != HL_ROOT_KEPT) continue;
        CHECK(face->values[r] == ldexp(first->values[r], shift), "%ld: value at root %d", n, r);
        ++kept;
      }
    }
  }
  CHECK(kept > TIMES(300), "only %ld roots were kept", kept);
}

/* The minimum query's test of a face: never no for one with a value below the bound. */
static void faces_that_are_lower_are_not_passed_over(void) {
  static const int edges_of[6][4] = {{3, 7, 8, 10},  {1, 5, 9, 11}, {0, 4, 8, 9},
                                     {2, 6, 10, 11}, {0, 1, 2, 3},  {4, 5, 6, 7}};
  static const double sigmas[4] = {0.3, 0.5, 1, 2};
  long asked = 0;
  for (long n = 0; n < TIMES(50000); ++n) {
    double vertices[24], bernstein[27];
    edge_vectors edges;
    if (n % 2) {
      double power[3][3] = {{0}}, size = ldexp(1, -20 - (int)(20 * random_unit(&stream)));
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3 - (i == 2); ++j) power[i][j] = size * random_normal(&stream);
      power[0][0] = 1; /* nearly flat: its values are near the clearances */
      hexahedron_of_face(power, vertices);
    } else random_hexahedron(&stream, sigmas[n / 2 % 4], vertices);
    scaled_edge_vectors(vertices, &edges);
    jacdet_bernstein(&edges, bernstein);
    for (int f = 0; f < 6; ++f) {
      double beta[9];
      face_solution solution;
      hl_candidate candidate;
      face_bernstein(bernstein, f, beta);
      double of_edges = fmin(fmin(beta[0], beta[2]), fmin(beta[6], beta[8])), of_face = INFINITY;
      for (int e = 0; e < 4; ++e)
        if (edge_candidate(bernstein, edges_of[f][e], of_edges, &candidate)) of_edges = candidate.value;
      find_kept_roots(beta, &solution);
      for (int r = 0; r < solution.root_count; ++r) of_face = fmin(of_face, solution.values[r]);
      if (!(of_face < of_edges)) continue;
      for (int k = 0; k < 40; k += 4) {
        const double bound = of_face + ldexp(of_edges - of_face, -k);
        ++asked;
        CHECK(face_can_be_lower(beta, bound), "%ld: face %d, %g below %g", n, f, bound - of_face, bound);
      }
    }
  }
  CHECK(asked > TIMES(10000), "only %ld faces were asked about", asked);
}

int main(void) {
  RUN(shallow_valleys);
  RUN(random_polynomials);
  RUN(squares);
  RUN(tiny_faces_scale_exactly);
  RUN(faces_that_are_lower_are_not_passed_over);
  return test_summary();
}
