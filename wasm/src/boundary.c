/* Algorithm 1: vertices, then edges, then faces. The report takes all candidates, the minimum query may skip faces by their
   Bernstein bound: docs/algorithm.md 4 and 6. */
#include "bernstein.h"
#include "candidates.h"
#include "checks.h"
#include "error_bounds.h"
#include "exact.h"
#include "face.h"
#include "filter.h"
#include "hexlens.h"
#include "map.h"
#include "report.h"
#include "subdivision.h"
#include "tangents.h"
#include "topology.h"
#include "volume.h"

#include <float.h>
#include <math.h>

/* Algorithm 1 on given coefficients, in their units. Where a face cannot be lower, rounding is not to make it so. */
static hl_candidate least_candidate(const double bernstein[27], hl_variant variant) {
  hl_candidate least = vertex_candidate(bernstein, 0), candidate;
  for (int v = 1; v < HL_VERTICES; ++v) {
    candidate = vertex_candidate(bernstein, v);
    if (candidate.value < least.value) least = candidate;
  }
  for (int e = 0; e < HL_EDGES; ++e) edge_candidate(bernstein, e, least.value, &least);
  for (int f = 0; f < HL_FACES; ++f) {
    double beta[HL_FACE_BERNSTEIN];
    face_bernstein(bernstein, f, beta);
    if (variant == HL_ROOTS_B && least_of(beta, HL_FACE_BERNSTEIN) >= least.value) continue;
    face_solution solution;
    find_kept_roots(beta, &solution);
    if (!face_can_be_lower(beta, least.value)) continue;
    for (int r = 0; r < solution.root_count; ++r)
      if (solution.values[r] < least.value) least = face_candidate(f, &solution, r);
  }
  return least;
}

static hl_candidate greatest_candidate(const double bernstein[27]) {
  double negated[27];
  for (int i = 0; i < 27; ++i) negated[i] = -bernstein[i];
  hl_candidate greatest = least_candidate(negated, HL_ROOTS_B);
  greatest.value = -greatest.value + 0.0;
  return greatest;
}

static void append(hl_report *report, hl_candidate candidate) {
  report->candidates[report->candidate_count++] = candidate;
}

static double least_candidate_value(const hl_report *report) {
  double least = report->candidates[0].value;
  for (int i = 1; i < report->candidate_count; ++i) least = smaller(least, report->candidates[i].value);
  return least;
}

void judge_face(double running_minimum, hl_face_report *face) {
  face->lower_bound = least_of(face->bernstein, HL_FACE_BERNSTEIN);
  face->running_minimum = running_minimum;
  face->skipped_by_minimum_rule = face->lower_bound >= face->running_minimum;
  face->skipped_by_validity_rule = face->lower_bound > 0;
}

static void report_face(hl_report *report, int face) {
  hl_face_report *out = &report->faces[face];
  face_bernstein(report->bernstein, face, out->bernstein);
  judge_face(least_candidate_value(report), out);
  face_solution solution;
  solve_face(out->bernstein, &solution);
  for (int i = 0; i < HL_QUARTIC; ++i) out->quartic[i] = solution.quartic[i];
  out->quartic_exponent = solution.quartic_exponent;
  out->quartic_is_zero = solution.quartic_is_zero;
  out->root_count = solution.root_count;
  for (int r = 0; r < solution.root_count; ++r) {
    out->roots[r] = solution.roots[r];
    if (solution.roots[r].fate == HL_ROOT_KEPT) append(report, face_candidate(face, &solution, r));
  }
}

/* The least candidate of the list, by the rules of least_candidate. */
static hl_candidate least_listed(const hl_report *report) {
  hl_candidate least = report->candidates[0];
  for (int i = 1, face = -1; i < report->candidate_count; ++i) {
    const hl_candidate *candidate = &report->candidates[i];
    if (!(candidate->value < least.value)) continue;
    /* A face is judged by what came before it. */
    const bool is_new_face = candidate->kind == HL_FACE && candidate->id != face;
    if (is_new_face && !face_can_be_lower(report->faces[candidate->id].bernstein, least.value)) continue;
    if (candidate->kind == HL_FACE) face = candidate->id;
    least = *candidate;
  }
  return least;
}

/* (M1): what the coefficients are off by, and on the faces that could hold the minimum what P can miss. */
static double error_of_minimum(const hl_report *report, double coefficient_error) {
  double unit = greatest_magnitude(report->bernstein, HL_BERNSTEIN), missed = CANDIDATE_ROUNDINGS * unit;
  for (int f = 0; f < HL_FACES; ++f) {
    const hl_face_report *face = &report->faces[f];
    if (face->lower_bound >= report->minimizer.value) continue;
    double on_face = QUARTIC_MISS_ROUNDINGS * greatest_magnitude(face->bernstein, HL_FACE_BERNSTEIN);
    if (on_face > missed) missed = on_face;
  }
  return coefficient_error + missed * UNIT_ROUNDOFF;
}

/* The volume minimum is the boundary minimum unless the element is invalid (the paper's theorem). */
static hl_volume_minimum volume_minimum_of(const hl_report *report, double coefficient_error) {
  const hl_candidate *least = &report->minimizer;
  if (report->verdict == HL_INVALID) return bracketed_volume_minimum(report->bernstein, coefficient_error, least);
  return (hl_volume_minimum){.lower = least->value - report->minimum_error,
                             .upper = least->value + report->minimum_error,
                             .point = {least->point[0], least->point[1], least->point[2]}};
}

/* The sources of the checks' numbers. */
typedef struct checked {
  const double *vertices, *bernstein;
  const edge_vectors *edges;
  precision given;
  middle_point middle;
  double corner_minimum, edge_minimum;
  hl_verdict verdict;
  double minimum;
} checked;

/* No value of a valid element is below the minimum, whatever rounding says. */
static double on_element(const checked *e, double value) {
  return e->verdict == HL_VALID && value < e->minimum ? e->minimum : value;
}

static double scaled_jacobian_of(const checked *e) {
  middle_point middle = e->middle;
  middle.jacdet = on_element(e, middle.jacdet);
  return least_scaled_jacobian(e->edges, e->bernstein, &middle, e->given.exponent);
}

static double fill_checks(const checked *e, double checks[HL_CHECKS]) {
  const double scaled_jacobian = scaled_jacobian_of(e);
  checks[HL_CHECK_CORNERS] = e->corner_minimum;
  checks[HL_CHECK_CORNERS_AND_CENTRE] = scaled_jacobian_of_verdict(e->vertices, scaled_jacobian);
  checks[HL_CHECK_GAUSS_2] = on_element(e, least_at_gauss_points(e->bernstein, 2));
  checks[HL_CHECK_GAUSS_3] = on_element(e, least_at_gauss_points(e->bernstein, 3));
  checks[HL_CHECK_EDGES] = e->edge_minimum;
  checks[HL_CHECK_BERNSTEIN] = least_coefficient(e->bernstein);
  checks[HL_CHECK_SUBDIVISION] = subdivision_to_depth_4(e->bernstein);
  checks[HL_CHECK_TANGENTS] = tangent_bound(e->bernstein, e->given.error, REPORTED_TANGENTS);
  return scaled_jacobian;
}

int list_jacdets(hl_report *report, double *list[MAX_JACDETS]) {
  int count = 0;
  list[count++] = &report->minimizer.value;
  list[count++] = &report->minimum_error;
  list[count++] = &report->volume_minimum.lower;
  list[count++] = &report->volume_minimum.upper;
  list[count++] = &report->maximizer.value;
  list[count++] = &report->corner_minimum;
  list[count++] = &report->edge_minimum;
  for (int i = 0; i < HL_CHECKS; ++i)
    if (i != HL_CHECK_CORNERS_AND_CENTRE) list[count++] = &report->checks[i];
  for (int i = 0; i < HL_BERNSTEIN; ++i) list[count++] = &report->bernstein[i];
  for (int i = 0; i < report->candidate_count; ++i) list[count++] = &report->candidates[i].value;
  for (int f = 0; f < HL_FACES; ++f) {
    hl_face_report *face = &report->faces[f];
    for (int i = 0; i < HL_FACE_BERNSTEIN; ++i) list[count++] = &face->bernstein[i];
    list[count++] = &face->lower_bound;
    list[count++] = &face->running_minimum;
    for (int r = 0; r < face->root_count; ++r) list[count++] = &face->roots[r].a;
  }
  return count;
}

/* Multiplies the exponent into all values if that is exact for every one; returns the exponent that is left. From integers a least
   normal double may stand for a smaller number, and stays what it is. */
static int exponent_left(hl_report *report, int exponent) {
  double *jacdets[MAX_JACDETS];
  int count = list_jacdets(report, jacdets);
  double least = INFINITY, greatest = 0; /* the least that is not 0 */
  for (int i = 0; i < count; ++i) {
    const double size = fabs(*jacdets[i]);
    if (report->is_exact && size == DBL_MIN) return exponent;
    if (size != 0) least = smaller(least, size);
    greatest = larger(greatest, size);
  }
  if (greatest == 0) return 0;
  if (!is_normal_after_scaling(least, exponent) || !is_normal_after_scaling(greatest, exponent)) return exponent;
  for (int i = 0; i < count; ++i) *jacdets[i] = times_power_of_two(*jacdets[i], exponent);
  return 0;
}

bool is_settled_by_doubles(const double bernstein[27], double permanent, double minimum, hl_verdict *verdict) {
  if (greatest_magnitude(bernstein, HL_BERNSTEIN) < LEAST_PART_OF_PERMANENT * permanent) return false;
  /* A computed minimum that contradicts a certain verdict has lost its sign: exact arithmetic gives both. */
  return is_settled_by_filter(bernstein, verdict) && !(*verdict == HL_VALID && !(minimum > 0));
}

void find_candidates(const double vertices[24], hl_report *report) {
  report->candidate_count = 0;
  for (int v = 0; v < HL_VERTICES; ++v) append(report, vertex_candidate(report->bernstein, v));
  report->corner_minimum = least_candidate_value(report);
  for (int e = 0; e < HL_EDGES; ++e) {
    hl_candidate candidate;
    if (edge_candidate(report->bernstein, e, INFINITY, &candidate)) append(report, candidate);
  }
  report->edge_minimum = least_candidate_value(report);
  for (int f = 0; f < HL_FACES; ++f) report_face(report, f);

  for (int i = 0; i < report->candidate_count; ++i) map_candidate(vertices, &report->candidates[i]);
  report->minimizer = least_listed(report);
  report->maximizer = greatest_candidate(report->bernstein);
  map_candidate(vertices, &report->maximizer);
}

void complete_report(const double vertices[24], const edge_vectors *edges, precision given, const middle_point *middle,
                     hl_report *report) {
  report->minimum_error = error_of_minimum(report, given.boundary_error);
  report->volume_minimum = volume_minimum_of(report, given.error);
  map_point(vertices, report->volume_minimum.point, report->volume_minimum.position);
  const checked e = {.vertices = vertices,
                     .bernstein = report->bernstein,
                     .edges = edges,
                     .given = given,
                     .middle = *middle,
                     .corner_minimum = report->corner_minimum,
                     .edge_minimum = report->edge_minimum,
                     .verdict = report->verdict,
                     .minimum = report->minimizer.value};
  report->scaled_jacobian = fill_checks(&e, report->checks);
}

/* All jacdets of the report are times 2^exponent, and become what they are if that is exact. The minimum comes once more, since in a
   report its size may be lost beside the greatest jacdet. */
static void finish_report(const double vertices[24], int exponent, int quartic_exponent, scaled_double minimum,
                          hl_report *report) {
  report->exponent = exponent_left(report, exponent);
  for (int f = 0; f < HL_FACES; ++f) {
    hl_face_report *face = &report->faces[f];
    face->quartic_exponent = scaled_back(face->quartic, HL_QUARTIC, face->quartic_exponent + 3 * quartic_exponent);
  }
  const scaled_double volume = find_volume(vertices);
  report->volume = volume.mantissa;
  report->volume_exponent = scaled_back(&report->volume, 1, volume.exponent);
  report->relative_minimum =
      relative_minimum(minimum.mantissa, minimum.exponent, report->volume, report->volume_exponent);
  report->element_class = class_of(vertices, report->verdict);
  report->shape = find_coincidences(vertices, report->coincident);
}

static void analyze_in_doubles(const double vertices[24], const edge_vectors *edges, precision computed,
                               hl_report *report) {
  const middle_point middle = middle_in_doubles(edges, report->bernstein);
  complete_report(vertices, edges, computed, &middle, report);
  const scaled_double minimum = {report->minimizer.value, computed.exponent};
  finish_report(vertices, computed.exponent, computed.exponent, minimum, report);
}

static void analyze_in_integers(const double vertices[24], const edge_vectors *edges, hl_report *report) {
  exact_values x;
  find_exact_values(vertices, &x, NULL);
  const int exponent = exact_report(vertices, edges, &x, report);
  finish_report(vertices, exponent, x.unit, x.boundary.minimum, report);
}

hl_status hl_analyze(const double vertices[24], hl_report *report) {
  if (!all_finite(vertices, HL_COORDINATES)) return HL_NOT_FINITE;
  edge_vectors edges;
  scaled_edge_vectors(vertices, &edges);
  double permanent = greatest_permanent(&edges);
  precision computed = {.boundary_error = BOUNDARY_ERROR * permanent + UNDERFLOW_ERROR,
                        .error = CENTRE_ERROR * permanent + UNDERFLOW_ERROR,
                        .exponent = jacdet_exponent(&edges)};
  jacdet_bernstein(&edges, report->bernstein);
  find_candidates(vertices, report);
  report->is_exact = !is_settled_by_doubles(report->bernstein, permanent, report->minimizer.value, &report->verdict);
  if (report->is_exact) analyze_in_integers(vertices, &edges, report);
  else analyze_in_doubles(vertices, &edges, computed, report);
  return HL_OK;
}

hl_status analyze_exactly(const double vertices[24], hl_report *report) {
  if (!all_finite(vertices, HL_COORDINATES)) return HL_NOT_FINITE;
  edge_vectors edges;
  scaled_edge_vectors(vertices, &edges);
  report->is_exact = true;
  analyze_in_integers(vertices, &edges, report);
  return HL_OK;
}

static unsigned accepting(const double checks[HL_CHECKS]) {
  unsigned bits = 0;
  for (int c = 0; c < HL_CHECKS; ++c) bits |= (unsigned)(checks[c] > 0) << c;
  return bits;
}

/* The sources of the checks' numbers, all but the edges' minimum; false where doubles leave the verdict open. */
static bool find_sources(const double vertices[24], edge_vectors *edges, double bernstein[27], checked *e) {
  scaled_edge_vectors(vertices, edges);
  jacdet_bernstein(edges, bernstein);
  const double permanent = greatest_permanent(edges);
  *e = (checked){.vertices = vertices,
                 .bernstein = bernstein,
                 .edges = edges,
                 .given = {.error = CENTRE_ERROR * permanent + UNDERFLOW_ERROR, .exponent = jacdet_exponent(edges)},
                 .middle = middle_in_doubles(edges, bernstein),
                 .corner_minimum = bernstein[vertex_index(0)],
                 .minimum = least_candidate(bernstein, HL_ROOTS_B).value};
  for (int v = 1; v < HL_VERTICES; ++v) e->corner_minimum = smaller(e->corner_minimum, bernstein[vertex_index(v)]);
  return is_settled_by_doubles(bernstein, permanent, e->minimum, &e->verdict);
}

static unsigned accepting_exactly(const double vertices[24]) {
  hl_report report;
  analyze_exactly(vertices, &report);
  return accepting(report.checks);
}

unsigned checks_that_accept(const double vertices[24]) {
  edge_vectors edges;
  double bernstein[27], checks[HL_CHECKS];
  checked e;
  if (!find_sources(vertices, &edges, bernstein, &e)) return accepting_exactly(vertices);
  hl_candidate candidate = {.value = e.corner_minimum};
  for (int edge = 0; edge < HL_EDGES; ++edge) edge_candidate(bernstein, edge, candidate.value, &candidate);
  e.edge_minimum = candidate.value;
  fill_checks(&e, checks);
  return accepting(checks);
}

unsigned corner_checks_that_accept(const double vertices[24]) {
  edge_vectors edges;
  double bernstein[27];
  checked e;
  if (!find_sources(vertices, &edges, bernstein, &e)) return accepting_exactly(vertices) & CORNER_CHECKS;
  const double scaled_jacobian = scaled_jacobian_of_verdict(vertices, scaled_jacobian_of(&e));
  return (unsigned)(e.corner_minimum > 0) << HL_CHECK_CORNERS | (unsigned)(scaled_jacobian > 0)
                                                                    << HL_CHECK_CORNERS_AND_CENTRE;
}

hl_status hl_boundary_minimum(const double vertices[24], hl_variant variant, hl_minimum *minimum) {
  if (!all_finite(vertices, HL_COORDINATES)) return HL_NOT_FINITE;
  edge_vectors edges;
  double bernstein[27];
  hl_verdict verdict;
  scaled_edge_vectors(vertices, &edges);
  jacdet_bernstein(&edges, bernstein);
  int exponent = jacdet_exponent(&edges);
  minimum->minimizer = least_candidate(bernstein, variant);
  minimum->is_exact = !is_settled_by_doubles(bernstein, greatest_permanent(&edges), minimum->minimizer.value, &verdict);
  if (minimum->is_exact) {
    exact_minimum exact;
    find_exact_minimum(vertices, &exact, NULL);
    minimum->minimizer = exact.minimizer;
    minimum->minimizer.value = exact.minimum.mantissa;
    exponent = exact.minimum.exponent;
  }
  map_candidate(vertices, &minimum->minimizer);
  minimum->exponent = scaled_back(&minimum->minimizer.value, 1, exponent);
  return HL_OK;
}

hl_status hl_tangent_bound(const double vertices[24], int tangents, hl_bound *bound) {
  if (!all_finite(vertices, HL_COORDINATES)) return HL_NOT_FINITE;
  if (tangents < 1 || tangents > MAX_TANGENTS) return HL_NO_SUCH_RESOLUTION;
  edge_vectors edges;
  double bernstein[27];
  scaled_edge_vectors(vertices, &edges);
  jacdet_bernstein(&edges, bernstein);
  bound->value = tangent_bound(bernstein, CENTRE_ERROR * greatest_permanent(&edges) + UNDERFLOW_ERROR, tangents);
  bound->exponent = scaled_back(&bound->value, 1, jacdet_exponent(&edges));
  return HL_OK;
}

hl_status hl_decide(const double vertices[24], hl_verdict *verdict) {
  if (!all_finite(vertices, HL_COORDINATES)) return HL_NOT_FINITE;
  *verdict = HL_INVALID;
  if (is_zero_at_sight(vertices)) return HL_OK;
  edge_vectors edges;
  double bernstein[27];
  scaled_edge_vectors(vertices, &edges);
  jacdet_bernstein(&edges, bernstein);
  if (has_open_corner(bernstein) || !is_settled_by_filter(bernstein, verdict))
    *verdict = exact_verdict(vertices, bernstein, NULL);
  return HL_OK;
}
