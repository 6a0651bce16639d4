/* A libFuzzer target: any 24 doubles, bent towards degenerate and nearly valid elements, through every function of
   hexlens.h; a broken law prints the element and aborts. Sizes are compared in scaled units, docs/algorithm.md 2, in which
   the largest edge component of each axis is in [1/2, 1). Made and run by `make -C wasm fuzz`. */
#include "../../wasm/src/bernstein.h"
#include "../../wasm/src/exact.h"
#include "../../wasm/src/report.h"
#include "hexlens.h"
#include "random.h"
#include "reference.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* The input; bytes that are missing are zero. */
typedef struct fuzz_input {
  double vertices[HL_COORDINATES];
  double point[3];
  uint8_t shapes[16]; /* pairs of a shape and its argument */
} fuzz_input;

/* The element and the point that every law sees; both are printed if one is broken. */
static double element[HL_COORDINATES], place[3];
static int unit_exponent; /* scaled units of jacdet are 2^unit_exponent */

static void print_doubles(const char *what, const double *values, int count) {
  fprintf(stderr, "%s:", what);
  for (int i = 0; i < count; ++i) fprintf(stderr, "%s%a", i == 0 ? " " : ", ", values[i]);
  fprintf(stderr, "\n");
}

#define LAW(condition, ...)                                                                                            \
  do {                                                                                                                 \
    if (condition) break;                                                                                              \
    fprintf(stderr, "%s:%d: broken law: ", __FILE__, __LINE__);                                                        \
    fprintf(stderr, __VA_ARGS__);                                                                                      \
    fprintf(stderr, "\n");                                                                                             \
    print_doubles("vertices", element, HL_COORDINATES);                                                                \
    print_doubles("point", place, 3);                                                                                  \
    abort();                                                                                                           \
  } while (0)

/* Shapes: what turns any doubles into elements near a border. */

static void repeat_vertex(double *x, unsigned argument) {
  memmove(x + 3 * (argument % 8), x + 3 * (argument / 8 % 8), 3 * sizeof(double));
}

static void swap_vertices(double *x, unsigned argument) {
  for (int r = 0; r < 3; ++r) {
    double *p = &x[3 * (argument % 8) + (unsigned)r], *q = &x[3 * (argument / 8 % 8) + (unsigned)r], kept = *p;
    *p = *q;
    *q = kept;
  }
}

/* All in a plane of constant coordinate, or in one of two equal coordinates. */
static void flatten(double *x, unsigned argument) {
  for (int v = 0; v < 8; ++v) x[3 * v + (int)(argument % 3)] = argument & 128 ? x[argument / 3 % 3] : x[3 * v];
}

static void put_on_a_line(double *x, unsigned argument) {
  for (int v = 2; v < 8; ++v)
    for (int r = 0; r < 3; ++r) x[3 * v + r] = x[r] + (argument >> v & 1 ? v : 0.5) * (x[3 + r] - x[r]);
}

static void collapse(double *x, unsigned argument) {
  for (int i = 0; i < 24; ++i) x[i] = x[3 * (argument % 8) + (unsigned)i % 3];
}

static void make_small_integers(double *x, unsigned argument) {
  for (int i = 0; i < 24; ++i)
    if (isfinite(x[i])) x[i] = fmod(rint(x[i]), 2 + argument % 8);
}

static void scale_axis(double *x, unsigned argument) {
  for (int v = 0; v < 8; ++v)
    x[3 * v + (int)(argument % 3)] = ldexp(x[3 * v + (int)(argument % 3)], 8 * (int)argument - 1024);
}

static void scale_all(double *x, unsigned argument) {
  for (int i = 0; i < 24; ++i) x[i] = ldexp(x[i], 8 * (int)argument - 1024);
}

static void move_by_ulps(double *x, unsigned argument) {
  uint64_t bits;
  memcpy(&bits, &x[argument % 24], sizeof bits);
  bits += argument / 24 - 5u;
  memcpy(&x[argument % 24], &bits, sizeof bits);
}

/* Only the mantissas are kept: the cube's coordinates with displacements of up to 2 or down to 2^-60. */
static void move_to_cube(double *x, unsigned argument) {
  for (int i = 0; i < 24; ++i) {
    int exponent;
    if (isfinite(x[i]))
      x[i] = unit_cube[i] + ldexp(frexp(x[i], &exponent), 1 - (int)(argument & 128 ? argument % 61 : argument % 4));
  }
}

static void make_parallelepiped(double *x, unsigned argument) {
  for (int v = 0; v < 8; ++v)
    if (argument >> v & 1)
      for (int r = 0; r < 3; ++r) {
        double d[3] = {x[3 + r] - x[r], x[9 + r] - x[r], x[12 + r] - x[r]};
        x[3 * v + r] =
            x[r] + reference_corner[v][0] * d[0] + reference_corner[v][1] * d[1] + reference_corner[v][2] * d[2];
      }
}

static void between(const double *from, const double *to, double t, double *x) {
  for (int i = 0; i < 24; ++i) x[i] = (1 - t) * from[i] + t * to[i];
}

/* The last valid or the first invalid element on the way from the cube to the element. */
static void move_to_border(double *x, unsigned argument) {
  double to[24], low = 0, high = 1;
  memcpy(to, x, sizeof to);
  for (int step = 0; step < 53; ++step) {
    double middle = 0.5 * (low + high);
    hl_verdict verdict = HL_UNANSWERED;
    between(unit_cube, to, middle, x);
    if (hl_decide(x, &verdict) == HL_OK && (argument & 2 ? verdict != HL_INVALID : verdict == HL_VALID)) low = middle;
    else high = middle;
  }
  between(unit_cube, to, argument & 1 ? low : high, x);
}

/* Face -zeta becomes one that touches zero: f = a (q s - p)^2 + c (r t - u)^2 with small integers, in a unit of 2^-1000 to 2^0, by edges
   from it alone, as U = e1, V = e2 and p_2 = e1 + e2 + e3 give f = W_z - s W_y - t W_x. The last bit of one coordinate may go. */
static void touch_on_a_face(double *x, unsigned argument) {
  static const int low[4] = {0, 1, 3, 2}, high[4] = {4, 5, 7, 6};
  uint64_t bits;
  memcpy(&bits, &x[argument % 24], sizeof bits);
  const double q = (double)(2 + bits % 5), p = 1 + fmod((double)(bits >> 8 & 255), q - 1),
               r = (double)(2 + (bits >> 16) % 5), u = 1 + fmod((double)(bits >> 24 & 255), r - 1),
               a = (double)(1 + (bits >> 32) % 3), c = (double)(1 + (bits >> 36) % 3),
               unit = ldexp(1, bits >> 40 & 1 ? -(int)(bits >> 44) % 1000 : 0);
  const double constant = a * p * p + c * u * u - (argument & 32 ? 0x1p-40 : 0);
  for (int corner = 0; corner < 4; ++corner) {
    const double s = corner & 1, t = corner >> 1, base[3] = {s, t, s * t},
                 w[3] = {-c * r * r * t, -a * q * q * s, constant - 2 * a * q * p * s - 2 * c * r * u * t};
    for (int k = 0; k < 3; ++k) {
      x[3 * low[corner] + k] = base[k];
      x[3 * high[corner] + k] = base[k] + unit * w[k];
    }
  }
}

/* The exponents of the coordinates, from one of them or each its own, moved far apart. */
static void spread_exponents(double *x, unsigned argument) {
  for (int i = 0; i < 24; ++i) {
    int exponent;
    if (!isfinite(x[i]) || x[i] == 0) continue;
    const double mantissa = frexp(x[i], &exponent);
    uint64_t bits;
    memcpy(&bits, &mantissa, sizeof bits);
    const int spread = 1 << argument % 11;
    if (argument & 128 || (unsigned)i % 8 == argument / 11 % 8)
      x[i] = ldexp(mantissa, (int)(bits % (2u * (unsigned)spread)) - spread);
  }
}

/* Two vertices of an edge, or as many as make one of the shapes, at one position. */
static void coincide(double *x, unsigned argument) {
  static const int as[8][8] = {{0, 0, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 4, 7, 7}, {0, 1, 2, 3, 4, 4, 4, 4},
                               {0, 1, 2, 2, 4, 4, 4, 4}, {0, 1, 0, 3, 4, 5, 6, 7}, {0, 0, 2, 3, 4, 5, 5, 7},
                               {0, 1, 4, 3, 4, 4, 4, 4}, {0, 1, 2, 3, 4, 5, 0, 7}};
  for (int v = 0; v < 8; ++v) memcpy(x + 3 * v, x + 3 * as[argument % 8][v], 3 * sizeof *x);
}

static void leave(double *x, unsigned argument) { (void)x, (void)argument; }

static void (*const shapes[])(double *x, unsigned argument) = {
    leave,          repeat_vertex,       swap_vertices,    flatten,      put_on_a_line, collapse,
    scale_all,      make_small_integers, scale_axis,       move_by_ulps, move_to_cube,  make_parallelepiped,
    move_to_border, touch_on_a_face,     spread_exponents, coincide};

enum { SHAPES = sizeof shapes / sizeof shapes[0] };

/* Numbers with exponents. */

static bool same_number(double x, int x_exponent, double y, int y_exponent) {
  int ex, ey;
  double mx = frexp(x, &ex), my = frexp(y, &ey);
  return mx == my && (mx == 0 || ex + x_exponent == ey + y_exponent);
}

/* A report whose jacdets have no unit in common has the least normal double for a minimum that is too small beside the greatest. */
static bool is_lost_in(double x, int x_exponent, double y, int y_exponent) {
  int ex, ey;
  frexp(x, &ex);
  frexp(y, &ey);
  return fabs(x) == DBL_MIN && y != 0 && signbit(x) == signbit(y) && ey + y_exponent < ex + x_exponent;
}

static bool is_normal_or_zero(double x, int exponent) {
  int e;
  return frexp(x, &e) == 0 || (e + exponent >= -1021 && e + exponent <= 1024);
}

static bool is_plain(double x) { return isfinite(x) && !(x == 0 && signbit(x)); }

/* The sum over the axes of the exponents of the largest edge components. */
static int element_exponent(void) {
  int sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    bool found = false;
    int greatest = 0;
    for (int e = 0; e < HL_EDGES; ++e) {
      double p = element[3 * reference_edge[e][0] + axis], q = element[3 * reference_edge[e][1] + axis];
      bool overflows = !isfinite(q - p);
      int exponent;
      if (frexp(overflows ? 0.5 * q - 0.5 * p : q - p, &exponent) == 0) continue;
      exponent += overflows;
      if (!found || exponent > greatest) greatest = exponent;
      found = true;
    }
    sum += greatest;
  }
  return sum;
}

static double in_scaled_units(double jacdet, int exponent) { return ldexp(jacdet, exponent - unit_exponent); }

/* Laws. */

static void is_in_bounding_box(const double position[3], const char *what) {
  for (int r = 0; r < 3; ++r) {
    double low = element[r], high = element[r];
    for (int v = 1; v < 8; ++v) {
      low = fmin(low, element[3 * v + r]);
      high = fmax(high, element[3 * v + r]);
    }
    LAW(is_plain(position[r]) && position[r] >= low && position[r] <= high, "%s: position %a is outside", what,
        position[r]);
  }
}

static void is_in_its_place(const hl_candidate *c, const char *what) {
  static const int counts[3] = {HL_VERTICES, HL_EDGES, HL_FACES};
  LAW(c->kind <= HL_FACE && c->id >= 0 && c->id < counts[c->kind], "%s: kind %d, id %d", what, (int)c->kind, c->id);
  LAW(is_plain(c->value), "%s: value %a", what, c->value);
  is_in_bounding_box(c->position, what);
  for (int axis = 0; axis < 3; ++axis) {
    int from = 0, to = 1;
    if (c->kind == HL_VERTEX) from = to = reference_corner[c->id][axis];
    if (c->kind == HL_EDGE) {
      from = reference_corner[reference_edge[c->id][0]][axis];
      to = reference_corner[reference_edge[c->id][1]][axis];
    }
    if (c->kind == HL_FACE && c->id / 2 == axis) from = to = c->id % 2;
    bool is_there = from == to ? c->point[axis] == from : c->point[axis] > 0 && c->point[axis] < 1;
    LAW(is_plain(c->point[axis]) && is_there, "%s: kind %d, id %d at %a", what, (int)c->kind, c->id, c->point[axis]);
  }
}

/* det DF has 8 roundings in each of its columns' components, of size 1, and 6 products of three with 5 roundings: at most
   6 * (3 * 8 + 5) u < 200 u; a candidate's value is within the 448 u of (F1). */
static const double jacobian_error = 200 * UNIT_ROUNDOFF, point_value_error = (200 + 448) * UNIT_ROUNDOFF;

/* Sums of coefficients with weights of sum 1 add their roundings to the coefficients' 461 u: 1000 u are enough. */
static const double coefficient_slack = 1000 * UNIT_ROUNDOFF;

static double jacdet_in_scaled_units(const double point[3]) {
  hl_jacobian jacobian;
  LAW(hl_jacobian_at(element, point, &jacobian) == HL_OK, "no jacobian at a point of the cube");
  return in_scaled_units(jacobian.jacdet, jacobian.exponent);
}

static void has_its_value(const hl_candidate *c, int exponent) {
  double value = in_scaled_units(c->value, exponent), expected = jacdet_in_scaled_units(c->point);
  LAW(fabs(value - expected) <= point_value_error, "candidate of kind %d, id %d has %a, jacdet there is %a",
      (int)c->kind, c->id, value, expected);
}

static void candidates_are_in_order(const hl_report *report) {
  const hl_candidate *c = report->candidates;
  LAW(report->candidate_count >= HL_VERTICES && report->candidate_count <= HL_MAX_CANDIDATES, "%d candidates",
      report->candidate_count);
  int of_kind[3] = {0}, kept = 0;
  for (int i = 0; i < report->candidate_count; ++i) {
    is_in_its_place(&c[i], "candidate");
    has_its_value(&c[i], report->exponent);
    ++of_kind[c[i].kind];
    LAW(i == 0 || c[i].kind > c[i - 1].kind || (c[i].kind == c[i - 1].kind && c[i].id >= c[i - 1].id), "candidate %d",
        i);
  }
  for (int f = 0; f < HL_FACES; ++f)
    for (int r = 0; r < report->faces[f].root_count; ++r) kept += report->faces[f].roots[r].fate == HL_ROOT_KEPT;
  LAW(of_kind[HL_VERTEX] == HL_VERTICES && of_kind[HL_EDGE] <= HL_EDGES && of_kind[HL_FACE] == kept,
      "%d vertices, %d edges, %d face points of %d roots kept", of_kind[0], of_kind[1], of_kind[2], kept);
}

static void extremes_are_extreme(const hl_report *report) {
  double corner = INFINITY, edge = INFINITY;
  bool is_candidate = false;
  is_in_its_place(&report->minimizer, "minimizer");
  is_in_its_place(&report->maximizer, "maximizer");
  has_its_value(&report->maximizer, report->exponent);
  for (int i = 0; i < report->candidate_count; ++i) {
    const hl_candidate *c = &report->candidates[i];
    LAW(report->minimizer.value <= c->value, "candidate %d is below the minimum", i);
    double above =
        in_scaled_units(c->value, report->exponent) - in_scaled_units(report->maximizer.value, report->exponent);
    LAW(above <= 2 * point_value_error, "candidate %d is above the maximum", i);
    if (c->kind == HL_VERTEX) corner = fmin(corner, c->value);
    if (c->kind != HL_FACE) edge = fmin(edge, c->value);
    is_candidate = is_candidate ||
                   (c->kind == report->minimizer.kind && c->id == report->minimizer.id &&
                    c->value == report->minimizer.value && !memcmp(c->point, report->minimizer.point, sizeof c->point));
  }
  LAW(is_candidate, "the minimizer is none of the candidates");
  LAW(report->corner_minimum == corner && report->edge_minimum == edge, "corner or edge minimum");
}

static void face_is_consistent(const hl_report *report, int f) {
  const hl_face_report *face = &report->faces[f];
  double least = INFINITY;
  for (int i = 0; i < HL_FACE_BERNSTEIN; ++i) least = fmin(least, face->bernstein[i]);
  LAW(face->lower_bound == least, "face %d: bound", f);
  LAW(face->skipped_by_minimum_rule == (face->lower_bound >= face->running_minimum), "face %d: minimum rule", f);
  LAW(face->skipped_by_validity_rule == (face->lower_bound > 0), "face %d: validity rule", f);
  LAW(face->root_count >= 0 && face->root_count <= HL_MAX_ROOTS, "face %d: %d roots", f, face->root_count);
  for (int r = 0; r < face->root_count; ++r) {
    const hl_face_root *root = &face->roots[r];
    LAW(root->t > 0 && root->t < 1 && (r == 0 || root->t > root[-1].t), "face %d: root %d at %a", f, r, root->t);
    LAW((root->fate == HL_ROOT_A_NOT_POSITIVE) == !(root->a > 0), "face %d: root %d: a is %a", f, r, root->a);
    LAW(root->fate != HL_ROOT_KEPT || (root->s > 0 && root->s < 1), "face %d: root %d: s is %a", f, r, root->s);
  }
  for (int i = 0; i < report->candidate_count; ++i)
    if (report->candidates[i].kind == HL_FACE && report->candidates[i].id == f)
      LAW(report->candidates[i].value >= face->lower_bound, "face %d: candidate below its bound", f);
}

/* No point of the boundary, or of a valid element, is below the minimum less its error. */
static void nothing_is_below_the_minimum(const hl_report *report, const double inside[3]) {
  double minimum = in_scaled_units(report->minimizer.value, report->exponent);
  double least = minimum - in_scaled_units(report->minimum_error, report->exponent) - jacobian_error;
  LAW(report->minimum_error >= 0, "error of the minimum %a", report->minimum_error);
  for (int f = 0; f < HL_FACES; ++f) {
    double point[3] = {inside[0], inside[1], inside[2]};
    point[f / 2] = f % 2;
    double value = jacdet_in_scaled_units(point);
    LAW(value >= least, "face %d: %a is below the minimum %a", f, value, minimum);
  }
  double value = jacdet_in_scaled_units(inside);
  LAW(report->verdict != HL_VALID || value >= least, "valid, but %a is below the minimum %a", value, minimum);
}

/* The minimum over the element is at most that over its boundary, and the same if it is valid. `slack`, in scaled units, is for
   what jacdet at a point is off by, and the coefficients beyond the error they were given with. */
static void volume_minimum_is_bracketed(const hl_report *report, const double inside[3], double slack) {
  const hl_volume_minimum *volume = &report->volume_minimum;
  double lower = in_scaled_units(volume->lower, report->exponent);
  double upper = in_scaled_units(volume->upper, report->exponent);
  double minimum = in_scaled_units(report->minimizer.value, report->exponent);
  double error = in_scaled_units(report->minimum_error, report->exponent) + slack;
  for (int axis = 0; axis < 3; ++axis)
    LAW(volume->point[axis] >= 0 && volume->point[axis] <= 1, "volume minimum at %a", volume->point[axis]);
  is_in_bounding_box(volume->position, "volume minimum");
  LAW(volume->lower <= volume->upper, "volume minimum from %a to %a", lower, upper);
  LAW(lower <= minimum + error, "volume minimum from %a, above the boundary's %a", lower, minimum);
  LAW(report->verdict != HL_VALID || upper >= minimum - error, "valid, but the volume minimum is at most %a", upper);
  double there = jacdet_in_scaled_units(volume->point), elsewhere = jacdet_in_scaled_units(inside);
  LAW(there <= upper + slack, "volume minimum up to %a, but %a at its point", upper, there);
  LAW(elsewhere >= lower - slack, "volume minimum from %a, but %a at a point", lower, elsewhere);
  for (int check = HL_CHECK_GAUSS_2; check <= HL_CHECK_GAUSS_3; ++check) {
    double least = in_scaled_units(report->checks[check], report->exponent);
    LAW(least >= lower - coefficient_slack, "volume minimum from %a, but %a at a Gauss point", lower, least);
  }
}

static void checks_are_what_they_say(const hl_report *report) {
  const double *checks = report->checks;
  double least = INFINITY, error = ldexp(coefficient_slack, unit_exponent - report->exponent);
  for (int i = 0; i < HL_BERNSTEIN; ++i) least = fmin(least, report->bernstein[i]);
  LAW(checks[HL_CHECK_CORNERS] == report->corner_minimum && checks[HL_CHECK_EDGES] == report->edge_minimum &&
          checks[HL_CHECK_BERNSTEIN] == least,
      "a check of corners, edges or coefficients is not their minimum");
  LAW(fabs(report->scaled_jacobian) <= 1 + 0x1p-48, "scaled Jacobian %a", report->scaled_jacobian);
  LAW(checks[HL_CHECK_CORNERS_AND_CENTRE] == report->scaled_jacobian || checks[HL_CHECK_CORNERS_AND_CENTRE] == 1e30,
      "scaled Jacobian %a, by Verdict %a", report->scaled_jacobian, checks[HL_CHECK_CORNERS_AND_CENTRE]);
  for (int i = HL_CHECK_CORNERS; i <= HL_CHECK_EDGES; ++i)
    LAW(report->verdict != HL_VALID || checks[i] > 0, "valid, and check %d has %a", i, checks[i]);
  LAW(checks[HL_CHECK_SUBDIVISION] >= least - error, "subdivision ends at %a", checks[HL_CHECK_SUBDIVISION]);
  LAW(!(report->verdict == HL_INVALID && checks[HL_CHECK_TANGENTS] > 0), "invalid, and tangents certify it: %a",
      checks[HL_CHECK_TANGENTS]);
  LAW(checks[HL_CHECK_TANGENTS] <= report->minimizer.value + error, "tangents %a, above the minimum %a",
      checks[HL_CHECK_TANGENTS], report->minimizer.value);
}

static void verdicts_agree(const hl_report *report) {
  hl_verdict verdict = HL_UNANSWERED;
  LAW(hl_decide(element, &verdict) == HL_OK, "decide refuses");
  LAW(verdict == report->verdict, "decide says %d, analyze %d", (int)verdict, (int)report->verdict);
  LAW(verdict == (report->minimizer.value > 0 ? HL_VALID : HL_INVALID), "verdict %d, but the minimum is %a",
      (int)verdict, report->minimizer.value);
}

static void minima_are_the_same(const hl_report *report) {
  static double packed[2][HL_PACKED_MINIMUM];
  hl_minimum minima[2];
  memset(&minima[0], 0x5a, sizeof minima[0]);
  memset(&minima[1], 0xa5, sizeof minima[1]);
  for (int variant = HL_ROOTS; variant <= HL_ROOTS_B; ++variant) {
    LAW(hl_boundary_minimum(element, (hl_variant)variant, &minima[variant]) == HL_OK, "minimum refuses");
    LAW(hl_pack_minimum(&minima[variant], packed[variant]) == HL_PACKED_MINIMUM, "packed minimum");
  }
  LAW(!memcmp(packed[0], packed[1], sizeof packed[0]), "Roots and Roots+B differ");
  const hl_minimum *m = &minima[0];
  is_in_its_place(&m->minimizer, "minimum");
  LAW(m->exponent == 0 || !is_normal_or_zero(m->minimizer.value, m->exponent), "minimum: exponent %d", m->exponent);
  LAW((same_number(m->minimizer.value, m->exponent, report->minimizer.value, report->exponent) ||
       is_lost_in(report->minimizer.value, report->exponent, m->minimizer.value, m->exponent)) &&
          m->minimizer.kind == report->minimizer.kind && m->minimizer.id == report->minimizer.id &&
          !memcmp(m->minimizer.point, report->minimizer.point, sizeof m->minimizer.point),
      "analyze has %a 2^%d, the boundary minimum is %a 2^%d", report->minimizer.value, report->exponent,
      m->minimizer.value, m->exponent);
}

/* Plain numbers within the given space. */
static size_t packed_report(const hl_report *report, double packed[HL_PACKED_REPORT]) {
  size_t length = hl_pack_report(report, packed);
  LAW(length <= HL_PACKED_REPORT, "%zu doubles for %d", length, (int)HL_PACKED_REPORT);
  for (size_t i = 0; i < length; ++i) LAW(is_plain(packed[i]), "packed number %zu is %a", i, packed[i]);
  return length;
}

static void report_is_reproducible(const hl_report *report) {
  static double packed[HL_PACKED_REPORT], again[HL_PACKED_REPORT];
  static hl_report other;
  memset(&other, 0xa5, sizeof other);
  LAW(hl_analyze(element, &other) == HL_OK, "analyze refuses the second time");
  size_t length = packed_report(report, packed), second = packed_report(&other, again);
  LAW(length == second && !memcmp(packed, again, length * sizeof(double)), "a report depends on what was there before");
}

/* Whatever doubles decided: the same verdict, the same class, and a minimum within its error. */
static void integers_say_the_same(const hl_report *report, const double inside[3]) {
  static double packed[HL_PACKED_REPORT];
  static hl_report exact;
  edge_vectors edges;
  double bernstein[HL_BERNSTEIN];
  memset(&exact, 0xa5, sizeof exact);
  LAW(analyze_exactly(element, &exact) == HL_OK, "integers refuse");
  scaled_edge_vectors(element, &edges);
  jacdet_bernstein(&edges, bernstein);
  const hl_verdict verdict = exact_verdict(element, bernstein, NULL);
  LAW(verdict == report->verdict && exact.verdict == verdict, "doubles say %d, integers %d, their minimum %d",
      (int)report->verdict, (int)verdict, (int)exact.verdict);
  LAW(exact.element_class == report->element_class, "class %d, by integers %d", (int)report->element_class,
      (int)exact.element_class);
  LAW(exact.shape == report->shape && !memcmp(exact.coincident, report->coincident, sizeof exact.coincident) &&
          exact.volume == report->volume && exact.volume_exponent == report->volume_exponent,
      "shape, coincident vertices or volume");
  packed_report(&exact, packed);
  is_in_its_place(&exact.minimizer, "minimizer by integers");
  has_its_value(&exact.minimizer, exact.exponent);
  candidates_are_in_order(&exact);
  extremes_are_extreme(&exact);
  for (int f = 0; f < HL_FACES; ++f) face_is_consistent(&exact, f);
  nothing_is_below_the_minimum(&exact, inside);
  checks_are_what_they_say(&exact);
  volume_minimum_is_bracketed(&exact, inside, jacobian_error);
  if (report->is_exact) return;
  /* A unit that both exponents are near to. */
  double one = ldexp(report->minimizer.value, report->exponent - unit_exponent),
         two = ldexp(exact.minimizer.value, exact.exponent - unit_exponent),
         error = ldexp(report->minimum_error, report->exponent - unit_exponent);
  LAW(fabs(one - two) <= error + 0x1p-52 * fabs(two) + 0x1p-1060, "the minimum is %a, by integers %a, error %a", one,
      two, error);
}

/* The volume is the mean of the coefficients, which are off by the unit's last places each. */
static void class_and_volume_fit(const hl_report *report) {
  const hl_class c = report->element_class;
  LAW((report->verdict == HL_VALID) == (c == HL_CLASS_VALID) && c >= HL_CLASS_VALID && c <= HL_CLASS_COLLAPSED,
      "class %d of a verdict %d", (int)c, (int)report->verdict);
  double mean = 0, least = INFINITY, greatest = -INFINITY;
  for (int i = 0; i < HL_BERNSTEIN; ++i) {
    const double value = in_scaled_units(report->bernstein[i], report->exponent);
    mean += value / HL_BERNSTEIN;
    least = fmin(least, value);
    greatest = fmax(greatest, value);
  }
  const double volume = in_scaled_units(report->volume, report->volume_exponent);
  LAW(is_plain(report->volume), "volume %a", report->volume);
  LAW(fabs(volume - mean) <= coefficient_slack, "volume %a, the mean is %a", volume, mean);
  LAW(report->volume_exponent == 0 || !is_normal_or_zero(report->volume, report->volume_exponent), "its exponent %d",
      report->volume_exponent);
  LAW(c != HL_CLASS_VALID || report->volume > 0, "valid, with a volume of %a", report->volume);
  LAW(c != HL_CLASS_INVERTED || (report->volume < 0 && report->minimizer.value < 0 && least < coefficient_slack),
      "inverted, with a volume of %a", report->volume);
  LAW(c != HL_CLASS_COLLAPSED || (least == 0 && greatest == 0 && report->volume == 0), "collapsed, from %a to %a",
      least, greatest);
  double mirrored[HL_COORDINATES];
  hl_verdict verdict = HL_UNANSWERED;
  for (int i = 0; i < HL_COORDINATES; ++i) mirrored[i] = i % 3 == 1 ? -element[i] : element[i];
  hl_decide(mirrored, &verdict);
  LAW((verdict == HL_VALID) == (c == HL_CLASS_INVERTED), "class %d, mirrored %d", (int)c, (int)verdict);
}

/* The definition, from the boundary minimum, up to one division of rounded numbers. */
static void relative_minimum_is_the_quotient(const hl_report *report) {
  hl_minimum minimum;
  hl_boundary_minimum(element, HL_ROOTS_B, &minimum);
  const double relative = report->relative_minimum;
  LAW(isnan(relative) == (report->volume == 0), "relative minimum %a for a volume of %a", relative, report->volume);
  if (isnan(relative)) return;
  LAW((relative > 0) == (minimum.minimizer.value > 0) && (relative < 0) == (minimum.minimizer.value < 0),
      "relative minimum %a for a minimum of %a", relative, minimum.minimizer.value);
  int m, v;
  const double quotient = frexp(minimum.minimizer.value, &m) / fabs(frexp(report->volume, &v));
  const int power = m + minimum.exponent - v - report->volume_exponent;
  if (quotient == 0) return;
  if (power > 1024 || fabs(ldexp(quotient, power)) > DBL_MAX) {
    LAW(fabs(relative) == DBL_MAX, "relative minimum %a, not the greatest", relative);
  } else if (fabs(ldexp(quotient, power)) < DBL_MIN) {
    LAW(fabs(relative) == DBL_MIN, "relative minimum %a, not the least", relative);
  } else {
    LAW(relative == ldexp(quotient, power), "relative minimum %a, not %a", relative, ldexp(quotient, power));
  }
}

/* Two vertices have one number if and only if they have one position, and where a face or an edge has two of them jacdet is 0. */
static void coincidences_are_seen(const hl_report *report) {
  int at_a_point = 0;
  bool is_zero_somewhere = false;
  for (int v = 0; v < HL_VERTICES; ++v)
    for (int u = 0; u < v; ++u) {
      const double *p = element + 3 * u, *q = element + 3 * v;
      const bool is_same = p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
      int differing = 0;
      for (int axis = 0; axis < 3; ++axis) differing += reference_corner[u][axis] != reference_corner[v][axis];
      LAW(is_same == (report->coincident[u] == report->coincident[v]), "vertices %d and %d", u, v);
      LAW(report->coincident[v] <= v && report->coincident[report->coincident[v]] == report->coincident[v], "vertex %d",
          v);
      at_a_point += is_same;
      is_zero_somewhere = is_zero_somewhere || (is_same && differing < 3);
    }
  static const int pairs[4][2] = {
      {0, 28}, {2, 2}, {6, 6}, {7, 10}}; /* of each shape, how many pairs at least and at most */
  LAW(report->shape >= HL_NO_SHAPE && report->shape <= HL_TETRAHEDRON && at_a_point >= pairs[report->shape][0] &&
          at_a_point <= pairs[report->shape][1],
      "shape %d with %d pairs of vertices at one position", (int)report->shape, at_a_point);
  LAW(!is_zero_somewhere || report->minimizer.value <= 0, "vertices coincide, but the minimum is %a",
      report->minimizer.value);
}

/* A batch of the element, between two others, with all lists and with the verdict alone. */
static void a_batch_says_the_same(const hl_report *report) {
  enum { CELLS = 3 };
  double cells_of[CELLS * HL_COORDINATES], minima[CELLS], minimizers[3 * CELLS], corners[CELLS], relative[CELLS],
      volumes[CELLS];
  uint8_t verdicts[CELLS], alone[CELLS], statuses[CELLS], is_exact[CELLS], classes[CELLS];
  uint16_t accepted_by[CELLS];
  int16_t exponents[CELLS], volume_exponents[CELLS];
  memcpy(cells_of, unit_cube, sizeof unit_cube);
  memcpy(cells_of + HL_COORDINATES, element, sizeof element);
  memcpy(cells_of + 2 * HL_COORDINATES, unit_cube, sizeof unit_cube);
  cells_of[2 * HL_COORDINATES + 5] = NAN;
  const hl_cells cells = {.coordinates = cells_of, .coordinate_count = CELLS * HL_COORDINATES};
  hl_batch batch = {verdicts, statuses, is_exact,         classes, accepted_by, minima, minimizers, corners, exponents,
                    relative, volumes,  volume_exponents, 0,       0,           0,      0,          0},
           verdict_only = {.verdicts = alone};
  LAW(hl_classify(&cells, &batch) == HL_OK && hl_classify(&cells, &verdict_only) == HL_OK, "a batch is refused");
  LAW(batch.unanswered == 1 && batch.first_unanswered == 2 && statuses[2] == HL_NOT_FINITE && verdicts[0] == HL_VALID,
      "%zu unanswered, from %zu on", batch.unanswered, batch.first_unanswered);
  unsigned accepted = 0;
  for (int c = 0; c < HL_CHECKS; ++c) accepted |= (unsigned)(report->checks[c] > 0) << c;
  LAW(verdicts[1] == report->verdict && alone[1] == report->verdict && statuses[1] == HL_OK &&
          is_exact[1] == report->is_exact && classes[1] == report->element_class && accepted_by[1] == accepted,
      "in a batch: verdict %d and %d, exact %d, class %d, accepted by %x, not %x", verdicts[1], alone[1], is_exact[1],
      classes[1], accepted_by[1], accepted);
  hl_minimum minimum;
  hl_boundary_minimum(element, HL_ROOTS_B, &minimum);
  LAW(same_number(minima[1], exponents[1], minimum.minimizer.value, minimum.exponent) &&
          !memcmp(minimizers + 3, minimum.minimizer.point, 3 * sizeof(double)),
      "in a batch: minimum %a 2^%d, not %a 2^%d", minima[1], exponents[1], minimum.minimizer.value, minimum.exponent);
  LAW(same_number(corners[1], exponents[1], report->corner_minimum, report->exponent) || fabs(corners[1]) == DBL_MIN ||
          fabs(corners[1]) == DBL_MAX || fabs(report->corner_minimum) == DBL_MIN,
      "in a batch: corner %a 2^%d", corners[1], exponents[1]);
  LAW((relative[1] == report->relative_minimum || (isnan(relative[1]) && isnan(report->relative_minimum))) &&
          volumes[1] == report->volume && volume_exponents[1] == report->volume_exponent,
      "in a batch: relative minimum %a, not %a, volume %a, not %a", relative[1], report->relative_minimum, volumes[1],
      report->volume);
}

static void jacobian_is_plain(const double point[3]) {
  static double packed[HL_PACKED_JACOBIAN];
  hl_jacobian jacobian;
  memset(&jacobian, 0x5a, sizeof jacobian);
  LAW(hl_jacobian_at(element, point, &jacobian) == HL_OK, "jacobian refuses");
  is_in_bounding_box(jacobian.position, "jacobian");
  LAW(hl_pack_jacobian(&jacobian, packed) == HL_PACKED_JACOBIAN, "packed jacobian");
  for (int i = 0; i < HL_PACKED_JACOBIAN; ++i) LAW(is_plain(packed[i]), "packed number %d is %a", i, packed[i]);
  LAW(jacobian.exponent == 0 || !is_normal_or_zero(jacobian.jacdet, jacobian.exponent), "jacobian: exponent %d",
      jacobian.exponent);
}

static hl_status expected_status(const double *point) {
  for (int i = 0; i < 24; ++i)
    if (!isfinite(element[i])) return HL_NOT_FINITE;
  for (int axis = 0; point && axis < 3; ++axis)
    if (!isfinite(point[axis])) return HL_NOT_FINITE;
  for (int axis = 0; point && axis < 3; ++axis)
    if (!(point[axis] >= 0 && point[axis] <= 1)) return HL_OUTSIDE_CUBE;
  return HL_OK;
}

/* The right status from all, and outputs as they were wherever it is a refusal. */
static void refusals_leave_outputs(hl_report *report) {
  static hl_report report_before;
  hl_minimum minimum, minimum_before;
  hl_jacobian jacobian, jacobian_before;
  hl_verdict verdict = HL_VALID;
  memset(report, 0x5a, sizeof *report);
  memset(&minimum, 0x5a, sizeof minimum);
  memset(&jacobian, 0x5a, sizeof jacobian);
  memcpy(&report_before, report, sizeof report_before);
  memcpy(&minimum_before, &minimum, sizeof minimum);
  memcpy(&jacobian_before, &jacobian, sizeof jacobian);
  hl_status status = expected_status(NULL), point_status = expected_status(place);
  LAW(hl_analyze(element, report) == status, "analyze: not status %d", (int)status);
  LAW(hl_decide(element, &verdict) == status, "decide: not status %d", (int)status);
  LAW(hl_boundary_minimum(element, HL_ROOTS_B, &minimum) == status, "minimum: not status %d", (int)status);
  LAW(hl_jacobian_at(element, place, &jacobian) == point_status, "jacobian: not status %d", (int)point_status);
  LAW(point_status == HL_OK || !memcmp(&jacobian, &jacobian_before, sizeof jacobian), "jacobian: output touched");
  if (status == HL_OK) return;
  LAW(!memcmp(report, &report_before, sizeof report_before) && !memcmp(&minimum, &minimum_before, sizeof minimum) &&
          verdict == HL_VALID,
      "a refusal touches the output");
}

static long double bernstein_value(const double *p, int degree, long double t) {
  long double level[HL_QUARTIC];
  for (int i = 0; i <= degree; ++i) level[i] = p[i];
  for (int n = degree; n > 0; --n)
    for (int i = 0; i < n; ++i) level[i] = (1 - t) * level[i] + t * level[i + 1];
  return level[0];
}

/* Ascending in (0,1), each a zero within rounding or at a change of sign, none missed where the sign changes. The core's
   evaluation is off by at most 12 u of the greatest coefficient (18), this one's by no more; 2^-1068 is for subnormals. */
static void roots_are_roots(const double *coefficients, int degree) {
  double p[HL_QUARTIC], roots[HL_MAX_ROOTS], greatest = 0;
  for (int i = 0; i <= degree; ++i) {
    p[i] = isfinite(coefficients[i]) ? coefficients[i] : 0;
    if (fabs(p[i]) > 0x1p1000) p[i] *= 0x1p-24;
    greatest = fmax(greatest, fabs(p[i]));
  }
  int count = hl_unit_roots(p, degree, roots);
  long double noise = 32 * UNIT_ROUNDOFF * (long double)greatest + 0x1p-1068L;
  bool ok = count >= 0 && count <= degree;
  for (int r = 0; ok && r < count; ++r) {
    ok = roots[r] > 0 && roots[r] < 1 && (r == 0 || roots[r] > roots[r - 1]);
    long double before = bernstein_value(p, degree, roots[r] - 0x1p-51L),
                after = bernstein_value(p, degree, roots[r] + 0x1p-51L);
    ok = ok && (fabsl(bernstein_value(p, degree, roots[r])) <= noise || (before < 0) != (after < 0));
  }
  enum { SAMPLES = 16 };
  double last = 0;
  long double last_value = 0;
  for (int i = 0; ok && i <= SAMPLES; ++i) {
    double t = (double)i / SAMPLES;
    long double value = bernstein_value(p, degree, t);
    if (fabsl(value) <= noise) continue;
    bool found = last_value == 0 || (last_value < 0) == (value < 0);
    for (int r = 0; r < count; ++r) found = found || (roots[r] >= last - 0x1p-51 && roots[r] <= t + 0x1p-51);
    ok = found;
    last = t;
    last_value = value;
  }
  if (ok) return;
  print_doubles("coefficients", p, degree + 1);
  print_doubles("roots", roots, count >= 0 && count <= HL_MAX_ROOTS ? count : 0);
  LAW(false, "%d roots of degree %d", count, degree);
}

static void check_all_laws(void) {
  static hl_report report;
  double given[HL_COORDINATES], inside[3];
  memcpy(given, element, sizeof given);
  for (int degree = 0; degree < HL_QUARTIC; ++degree) roots_are_roots(element + 4 * degree, degree);
  refusals_leave_outputs(&report);
  if (expected_status(NULL) != HL_OK) return;
  unit_exponent = element_exponent();
  for (int axis = 0; axis < 3; ++axis) {
    uint64_t bits;
    memcpy(&bits, &place[axis], sizeof bits);
    inside[axis] = place[axis] >= 0 && place[axis] <= 1 ? fabs(place[axis]) : (double)(bits >> 11) * 0x1p-53;
  }
  candidates_are_in_order(&report);
  extremes_are_extreme(&report);
  for (int f = 0; f < HL_FACES; ++f) {
    face_is_consistent(&report, f);
    roots_are_roots(report.faces[f].quartic, HL_QUARTIC - 1);
  }
  verdicts_agree(&report);
  minima_are_the_same(&report);
  report_is_reproducible(&report);
  integers_say_the_same(&report, inside);
  class_and_volume_fit(&report);
  relative_minimum_is_the_quotient(&report);
  coincidences_are_seen(&report);
  a_batch_says_the_same(&report);
  jacobian_is_plain(inside);
  nothing_is_below_the_minimum(&report, inside);
  volume_minimum_is_bracketed(&report, inside, jacobian_error);
  checks_are_what_they_say(&report);
  LAW(!memcmp(given, element, sizeof given), "the input was written to");
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
  fuzz_input input;
  memset(&input, 0, sizeof input);
  if (size > 0) memcpy(&input, bytes, size < sizeof input ? size : sizeof input);
  memcpy(element, input.vertices, sizeof element);
  memcpy(place, input.point, sizeof place);
  for (size_t i = 0; i + 1 < sizeof input.shapes; i += 2)
    shapes[input.shapes[i] % SHAPES](element, input.shapes[i + 1]);
  check_all_laws();
  return 0;
}

/* Mutations of whole doubles and of shapes; half are libFuzzer's own, of bytes. */

size_t LLVMFuzzerMutate(uint8_t *bytes, size_t size, size_t max_size);

static double random_double(random_stream *stream, double old) {
  static const double special[] = {
      0,        -0.0,      1,         0.5,       -1,     2,   1e308,    -1e308,
      0x1p1023, 0x1p-1022, 0x1p-1074, 0x1p-1030, 1e-300, NAN, INFINITY, 0x1.fffffffffffffp-1};
  switch (random_bits(stream) % 6) {
  case 0: return special[random_bits(stream) % (sizeof special / sizeof special[0])];
  case 1: return -old;
  case 2: return old * (1 + 0x1p-52 * (double)(random_bits(stream) % 9)) - old * 0x1p-50;
  case 3: return ldexp(old, (int)(random_bits(stream) % 129) - 64);
  case 4: return (double)(random_bits(stream) % 9) - 4;
  default: return random_normal(stream);
  }
}

size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t size, size_t max_size, unsigned seed) {
  random_stream stream = {seed};
  if (max_size < sizeof(fuzz_input) || random_bits(&stream) % 2) return LLVMFuzzerMutate(bytes, size, max_size);
  fuzz_input input;
  memset(&input, 0, sizeof input);
  memcpy(&input, bytes, size < sizeof input ? size : sizeof input);
  if (size < sizeof input.vertices) random_hexahedron(&stream, random_unit(&stream), input.vertices);
  for (uint64_t changes = 1 + random_bits(&stream) % 4; changes > 0; --changes) {
    double *x = &input.vertices[random_bits(&stream) % HL_COORDINATES];
    switch (random_bits(&stream) % 5) {
    case 0: input.shapes[random_bits(&stream) % sizeof input.shapes] = (uint8_t)random_bits(&stream); break;
    case 1: input.point[random_bits(&stream) % 3] = random_unit(&stream); break;
    case 2: *x = input.vertices[random_bits(&stream) % HL_COORDINATES]; break;
    default: *x = random_double(&stream, *x);
    }
  }
  memcpy(bytes, &input, sizeof input);
  return sizeof input;
}
