/* The report of an element that doubles leave open: what doubles make of the exact coefficients, each rounded once, with verdict, vertices,
   edges, minimum and checks from integers in its place. docs/algorithm.md 7. */
#include "bernstein.h"
#include "exact.h"
#include "map.h"
#include "report.h"
#include "topology.h"

#include <float.h>

/* Relative error of the exact values: they are enclosed to 2^-57 and then rounded. */
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
  for (int i = 0; i < count; ++i) *jacdets[i] = in_normal_range(times_power_of_two(*jacdets[i], exponent), *jacdets[i]);
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

static void take_out(hl_face_report *face, int root) {
  for (--face->root_count; root < face->root_count; ++root) face->roots[root] = face->roots[root + 1];
}

/* The kept root nearest to the minimizer makes room for it; where doubles kept none, the last one does if there are four. */
static void make_room(hl_face_report *face, double s, double t) {
  double least = 3; /* more than any squared distance */
  int nearest = face->root_count == HL_MAX_ROOTS ? HL_MAX_ROOTS - 1 : -1;
  for (int r = 0; r < face->root_count; ++r) {
    const hl_face_root *root = &face->roots[r];
    const double distance = (root->s - s) * (root->s - s) + (root->t - t) * (root->t - t);
    if (root->fate != HL_ROOT_KEPT || distance >= least) continue;
    least = distance;
    nearest = r;
  }
  if (nearest >= 0) take_out(face, nearest);
  for (int r = face->root_count; r-- > 0;)
    if (face->roots[r].t == t) take_out(face, r);
}

/* A minimizer on a face has a root. */
static void put_root(const hl_candidate *minimizer, hl_face_report *face) {
  const double s = minimizer->point[face_table[minimizer->id].s], t = minimizer->point[face_table[minimizer->id].t];
  const double *b = face->bernstein, a = lerp(b[0] - 2 * b[3] + b[6], b[2] - 2 * b[5] + b[8], t);
  make_room(face, s, t);
  int at = face->root_count++;
  for (; at > 0 && face->roots[at - 1].t > t; --at) face->roots[at] = face->roots[at - 1];
  face->roots[at] = (hl_face_root){.t = t, .a = larger(a, DBL_MIN), .s = s, .fate = HL_ROOT_KEPT};
}

static void append(hl_report *report, const hl_candidate *candidate) {
  report->candidates[report->candidate_count++] = *candidate;
}

static void append_exact(const double vertices[24], hl_candidate candidate, double value, hl_report *report) {
  candidate.value = value;
  map_candidate(vertices, &candidate);
  append(report, &candidate);
}

/* The face's kept roots in their order: the minimizer if it is one, else what doubles make of it, no lower than the minimum and
   the least coefficient. */
static void append_roots(const hl_candidate *listed, int count, int id, hl_report *report) {
  const hl_face_report *face = &report->faces[id];
  const int t = face_table[id].t;
  for (int r = 0; r < face->root_count; ++r) {
    if (face->roots[r].fate != HL_ROOT_KEPT) continue;
    const hl_candidate *least = &report->minimizer;
    const bool is_least = least->kind == HL_FACE && least->id == id && least->point[t] == face->roots[r].t;
    hl_candidate found = *least;
    for (int i = 0; i < count && !is_least; ++i)
      if (listed[i].id == id && listed[i].point[t] == face->roots[r].t) found = listed[i];
    if (!is_least) found.value = larger(larger(found.value, least->value), face->lower_bound);
    append(report, &found);
  }
}

/* The candidates and the faces again, with exact coefficients and exact values at vertices and on edges. */
static void put_candidates(const double vertices[24], const exact_values *x, int exponent, hl_report *report) {
  hl_candidate listed[HL_FACES * HL_MAX_ROOTS];
  int count = 0;
  for (int i = 0; i < report->candidate_count; ++i)
    if (report->candidates[i].kind == HL_FACE) listed[count++] = report->candidates[i];
  for (int i = 0; i < HL_BERNSTEIN; ++i) report->bernstein[i] = in_normal_units(x->coefficients[i], exponent);
  report->candidate_count = 0;
  for (int v = 0; v < HL_VERTICES; ++v)
    append_exact(vertices, x->vertex_candidates[v], in_normal_units(x->vertices[v], exponent), report);
  for (int e = 0; e < x->edge_count; ++e)
    append_exact(vertices, x->edge_candidates[e], in_normal_units(x->on_edges[e], exponent), report);
  double least = report->edge_minimum;
  for (int f = 0; f < HL_FACES; ++f) {
    hl_face_report *face = &report->faces[f];
    face_bernstein(report->bernstein, f, face->bernstein);
    judge_face(least, face);
    if (report->minimizer.kind == HL_FACE && report->minimizer.id == f) put_root(&report->minimizer, face);
    const int before = report->candidate_count;
    append_roots(listed, count, f, report);
    for (int i = before; i < report->candidate_count; ++i) least = smaller(least, report->candidates[i].value);
  }
}

int exact_report(const double vertices[24], const edge_vectors *edges, const exact_values *x, hl_report *report) {
  for (int i = 0; i < HL_BERNSTEIN; ++i) report->bernstein[i] = x->bernstein[i];
  find_candidates(vertices, report);
  report->verdict = x->boundary.minimum.mantissa > 0 ? HL_VALID : HL_INVALID;
  report->minimizer = x->boundary.minimizer;
  map_candidate(vertices, &report->minimizer);
  report->minimizer.value = in_normal_units(x->boundary.minimum, x->unit);
  report->corner_minimum = in_normal_units(x->boundary.corner_minimum, x->unit);
  const precision given = {.boundary_error = x->error, .error = x->error, .exponent = x->unit};
  middle_point middle = {.jacdet = in_normal_units(x->centre, x->unit)};
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) {
      const scaled_double number = x->columns[c][r];
      middle.columns[c][r] = times_power_of_two(number.mantissa, number.exponent - edges->axis_exponent[r]);
    }
  complete_report(vertices, edges, given, &middle, report);

  const int exponent = common_unit(x, x->unit);
  map_units(report, x->unit - exponent);
  hl_candidate *least = &report->minimizer;
  least->value = in_normal_units(x->boundary.minimum, exponent);
  report->minimum_error = error_of(least->value);
  report->corner_minimum = in_normal_units(x->boundary.corner_minimum, exponent);
  report->edge_minimum = in_normal_units(x->edge_minimum, exponent);
  put_candidates(vertices, x, exponent, report);
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
  checks[HL_CHECK_GAUSS_2] = in_normal_units(x->gauss_2, exponent);
  checks[HL_CHECK_GAUSS_3] = in_normal_units(x->gauss_3, exponent);
  checks[HL_CHECK_BERNSTEIN] = in_normal_units(x->bernstein_minimum, exponent);
  /* These accept by bounds, and so nothing that is invalid. */
  if (!is_valid) checks[HL_CHECK_SUBDIVISION] = smaller(checks[HL_CHECK_SUBDIVISION], 0);
  return exponent;
}
