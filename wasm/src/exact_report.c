/* The report of an element that doubles leave open: what doubles make of the exact coefficients, each rounded once, with verdict, vertices,
   edges, minimum and checks from integers in its place. docs/algorithm.md 7. */
#include "exact.h"
#include "bernstein.h"
#include "map.h"
#include "report.h"

#include <float.h>

/* Of the exact values: they are enclosed to 2^-60 and then rounded. */
#define VALUE_ERROR 0x1p-52

/* A value too small beside the unit is the least normal double of its sign. */
static double in_normal_range(double value, double before) {
  if (before == 0 || value >= DBL_MIN || value <= -DBL_MIN) return value;
  return before < 0 ? -DBL_MIN : DBL_MIN;
}

/* A root's a and the bracket's ends are at most four times the largest coefficient, and rounding. */
enum { MARGIN_BITS = 4 };

static void include_power(scaled_double x, int *least, int *greatest) {
  if (x.mantissa == 0) return;
  if (x.exponent < *least) *least = x.exponent;
  if (x.exponent > *greatest) *greatest = x.exponent;
}

/* A unit in which all exact values are normal doubles, if there is one: that of the coefficients where it does. If there is none, no
   number of the report is too large for the doubles. */
static int common_unit(const exact_values *x, int unit) {
  int least = INT32_MAX, greatest = unit + MARGIN_BITS;
  for (int v = 0; v < HL_VERTICES; ++v) include_power(x->vertices[v], &least, &greatest);
  for (int e = 0; e < x->edge_count; ++e) include_power(x->on_edges[e], &least, &greatest);
  include_power(x->boundary.minimum, &least, &greatest);
  if (least == INT32_MAX || (least - unit > DBL_MIN_EXP && greatest - unit < DBL_MAX_EXP)) return unit;
  const int highest = greatest - DBL_MAX_EXP, middle = (least + greatest) / 2;
  return highest > middle ? highest : middle;
}

static void map_units(hl_report *report, int exponent) {
  double *jacdets[MAX_JACDETS];
  const int count = exponent == 0 ? 0 : list_jacdets(report, jacdets);
  for (int i = 0; i < count; ++i)
    *jacdets[i] = in_normal_range(exponent < -2000 ? 0 : times_power_of_two(*jacdets[i], exponent), *jacdets[i]);
  /* A bracket stays one. */
  if (report->volume_minimum.lower == DBL_MIN) report->volume_minimum.lower = 0;
  if (report->volume_minimum.upper == -DBL_MIN) report->volume_minimum.upper = 0;
}

/* A least normal double may stand for a smaller number, and a subnormal product may be rounded down. */
static double error_of(double value) {
  const double size = value < 0 ? -value : value, error = VALUE_ERROR * size;
  if (size == DBL_MIN) return DBL_MIN;
  return error > 0 && error < DBL_MIN ? error + DBL_TRUE_MIN : error;
}

static double distance(const hl_candidate *a, const hl_candidate *b) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) sum += (a->point[axis] - b->point[axis]) * (a->point[axis] - b->point[axis]);
  return sum;
}

/* The face's root whose candidate the minimizer takes the place of, the nearest one; if doubles kept none, one is made. */
static void put_root(hl_face_report *face, const hl_candidate *minimizer, int replaced) {
  const int axis = minimizer->id / 2, s = axis == 0 ? 1 : 0, t = axis == 2 ? 1 : 2;
  hl_face_root root = {.t = minimizer->point[t], .a = 0, .s = minimizer->point[s], .fate = HL_ROOT_KEPT};
  for (int r = 0, kept = 0; r < face->root_count; ++r) {
    if (face->roots[r].fate != HL_ROOT_KEPT || kept++ != replaced) continue;
    face->roots[r].t = root.t;
    face->roots[r].s = root.s;
    return;
  }
  const double *b = face->bernstein, a0 = b[0] - 2 * b[3] + b[6], a1 = b[2] - 2 * b[5] + b[8];
  root.a = in_normal_range(lerp(a0, a1, root.t), 1);
  int at = face->root_count < HL_MAX_ROOTS ? face->root_count++ : HL_MAX_ROOTS - 1;
  for (; at > 0 && face->roots[at - 1].t > root.t; --at) face->roots[at] = face->roots[at - 1];
  face->roots[at] = root;
}

/* The candidates again: exact ones at vertices and on edges; on faces those of doubles, no lower than the minimum, which takes the
   place of the nearest one if a face has it. */
static void put_candidates(const double vertices[24], const exact_values *x, int unit, hl_report *report) {
  hl_candidate faces[HL_FACES * HL_MAX_ROOTS];
  int face_count = 0, nearest = -1, before = 0;
  const hl_candidate *least = &report->minimizer;
  for (int i = 0; i < report->candidate_count; ++i) {
    if (report->candidates[i].kind != HL_FACE) continue;
    hl_candidate *candidate = &faces[face_count];
    *candidate = report->candidates[i];
    candidate->value = larger(candidate->value, least->value);
    const bool is_its_face = least->kind == HL_FACE && candidate->id == least->id;
    if (is_its_face && (nearest < 0 || distance(candidate, least) < distance(&faces[nearest], least)))
      nearest = face_count;
    if (least->kind == HL_FACE && candidate->id < least->id) before = face_count + 1;
    ++face_count;
  }
  report->candidate_count = 0;
  for (int v = 0; v < HL_VERTICES; ++v) report->candidates[report->candidate_count++] = x->vertex_candidates[v];
  for (int e = 0; e < x->edge_count; ++e) report->candidates[report->candidate_count++] = x->edge_candidates[e];
  for (int i = 0; i < report->candidate_count; ++i) {
    hl_candidate *candidate = &report->candidates[i];
    candidate->value = in_normal_units(i < HL_VERTICES ? x->vertices[i] : x->on_edges[i - HL_VERTICES], unit);
    map_point(vertices, candidate->point, candidate->position);
  }
  if (least->kind == HL_FACE) put_root(&report->faces[least->id], least, nearest < 0 ? -1 : nearest - before);
  for (int i = 0; i <= face_count; ++i) {
    const bool is_inserted = least->kind == HL_FACE && nearest < 0 && i == before;
    if (is_inserted) report->candidates[report->candidate_count++] = *least;
    if (i < face_count) report->candidates[report->candidate_count++] = i == nearest ? *least : faces[i];
  }
}

int exact_report(const double vertices[24], const edge_vectors *edges, int *unit, hl_report *report) {
  exact_values x;
  find_exact_values(vertices, &x, NULL);
  for (int i = 0; i < HL_BERNSTEIN; ++i) report->bernstein[i] = x.bernstein[i];
  *unit = x.unit;
  find_candidates(vertices, report);
  report->verdict = x.boundary.minimum.mantissa > 0 ? HL_VALID : HL_INVALID;
  report->minimizer = x.boundary.minimizer;
  map_point(vertices, report->minimizer.point, report->minimizer.position);
  report->minimizer.value = in_normal_units(x.boundary.minimum, *unit);
  report->corner_minimum = in_normal_units(x.boundary.corner_minimum, *unit);
  const precision given = {.boundary_error = x.error, .error = x.error, .exponent = *unit};
  middle_point middle = {.jacdet = in_normal_units(x.centre, *unit)};
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) {
      const scaled_double number = x.columns[c][r];
      middle.columns[c][r] = times_power_of_two(number.mantissa, number.exponent - edges->axis_exponent[r]);
    }
  complete_report(vertices, edges, given, &middle, report);

  const int exponent = common_unit(&x, *unit);
  map_units(report, *unit - exponent);
  hl_candidate *least = &report->minimizer;
  least->value = in_normal_units(x.boundary.minimum, exponent);
  report->minimum_error = error_of(least->value);
  report->corner_minimum = in_normal_units(x.boundary.corner_minimum, exponent);
  report->edge_minimum = in_normal_units(x.edge_minimum, exponent);
  put_candidates(vertices, &x, exponent, report);
  hl_volume_minimum on_boundary = {.lower = least->value - report->minimum_error,
                                   .upper = least->value + report->minimum_error};
  for (int axis = 0; axis < 3; ++axis) {
    on_boundary.point[axis] = least->point[axis];
    on_boundary.position[axis] = least->position[axis];
  }
  /* The bracket of the search inside, but for its upper end where the boundary reaches lower. */
  const bool is_valid = report->verdict == HL_VALID;
  if (!is_valid) on_boundary.lower = smaller(on_boundary.lower, report->volume_minimum.lower);
  if (is_valid || on_boundary.upper <= report->volume_minimum.upper) report->volume_minimum = on_boundary;

  double *checks = report->checks;
  checks[HL_CHECK_CORNERS] = report->corner_minimum;
  checks[HL_CHECK_EDGES] = report->edge_minimum;
  checks[HL_CHECK_GAUSS_2] = in_normal_units(x.gauss_2, exponent);
  checks[HL_CHECK_GAUSS_3] = in_normal_units(x.gauss_3, exponent);
  checks[HL_CHECK_BERNSTEIN] = in_normal_units(x.bernstein_minimum, exponent);
  /* These accept by bounds, and so nothing that is invalid. */
  if (!is_valid) checks[HL_CHECK_SUBDIVISION] = smaller(checks[HL_CHECK_SUBDIVISION], 0);
  return exponent;
}
