/* Algorithm 1: vertices, then edges, then faces. The report takes all candidates, the minimum query may skip faces by their
   Bernstein bound: docs/algorithm.md 4 and 6. */
#include "bernstein.h"
#include "candidates.h"
#include "face.h"
#include "filter.h"
#include "hexlens.h"
#include "map.h"
#include "topology.h"

static double least_of(const double *values, int count) {
  double least = values[0];
  for (int i = 1; i < count; ++i) least = smaller(least, values[i]);
  return least;
}

/* Algorithm 1 on given coefficients, in their units. */
static hl_candidate least_candidate(const double bernstein[27], hl_variant variant) {
  hl_candidate least = vertex_candidate(bernstein, 0), candidate;
  for (int v = 1; v < HL_VERTICES; ++v) {
    candidate = vertex_candidate(bernstein, v);
    if (candidate.value < least.value) least = candidate;
  }
  for (int e = 0; e < HL_EDGES; ++e)
    if (edge_candidate(bernstein, e, &candidate) && candidate.value < least.value) least = candidate;
  for (int f = 0; f < HL_FACES; ++f) {
    double beta[HL_FACE_BERNSTEIN];
    face_bernstein(bernstein, f, beta);
    if (variant == HL_ROOTS_B && least_of(beta, HL_FACE_BERNSTEIN) >= least.value) continue;
    face_solution solution;
    find_kept_roots(beta, &solution);
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

static void report_face(hl_report *report, int face) {
  hl_face_report *out = &report->faces[face];
  face_bernstein(report->bernstein, face, out->bernstein);
  out->lower_bound = least_of(out->bernstein, HL_FACE_BERNSTEIN);
  out->running_minimum = least_candidate_value(report);
  out->skipped_by_minimum_rule = out->lower_bound >= out->running_minimum;
  out->skipped_by_validity_rule = out->lower_bound > 0;
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

/* Calls `visit` on every jacdet of the report. */
static void each_jacdet(hl_report *report, void (*visit)(double *jacdet, void *context), void *context) {
  visit(&report->minimizer.value, context);
  visit(&report->maximizer.value, context);
  visit(&report->corner_minimum, context);
  visit(&report->edge_minimum, context);
  for (int i = 0; i < HL_BERNSTEIN; ++i) visit(&report->bernstein[i], context);
  for (int i = 0; i < report->candidate_count; ++i) visit(&report->candidates[i].value, context);
  for (int f = 0; f < HL_FACES; ++f) {
    hl_face_report *face = &report->faces[f];
    for (int i = 0; i < HL_FACE_BERNSTEIN; ++i) visit(&face->bernstein[i], context);
    visit(&face->lower_bound, context);
    visit(&face->running_minimum, context);
    for (int r = 0; r < face->root_count; ++r) visit(&face->roots[r].a, context);
  }
}

typedef struct unscaling {
  int exponent;
  bool fits;
} unscaling;

static void check_fits(double *jacdet, void *context) {
  unscaling *u = context;
  if (!is_normal_after_scaling(*jacdet, u->exponent)) u->fits = false;
}

static void unscale(double *jacdet, void *context) {
  *jacdet = times_power_of_two(*jacdet, ((const unscaling *)context)->exponent);
}

/* Multiplies the exponent into all values if that is exact for every one; returns the exponent that is left. */
static int exponent_left(hl_report *report, int exponent) {
  unscaling u = {exponent, true};
  each_jacdet(report, check_fits, &u);
  if (!u.fits) return exponent;
  each_jacdet(report, unscale, &u);
  return 0;
}

hl_status hl_analyze(const double vertices[24], hl_report *report) {
  if (!all_finite(vertices, HL_COORDINATES)) return HL_NOT_FINITE;
  edge_vectors edges;
  scaled_edge_vectors(vertices, &edges);
  jacdet_bernstein(&edges, report->bernstein);

  report->candidate_count = 0;
  for (int v = 0; v < HL_VERTICES; ++v) append(report, vertex_candidate(report->bernstein, v));
  report->corner_minimum = least_candidate_value(report);
  for (int e = 0; e < HL_EDGES; ++e) {
    hl_candidate candidate;
    if (edge_candidate(report->bernstein, e, &candidate)) append(report, candidate);
  }
  report->edge_minimum = least_candidate_value(report);
  for (int f = 0; f < HL_FACES; ++f) report_face(report, f);

  for (int i = 0; i < report->candidate_count; ++i)
    map_point(vertices, report->candidates[i].point, report->candidates[i].position);
  report->minimizer = report->candidates[0];
  for (int i = 1; i < report->candidate_count; ++i)
    if (report->candidates[i].value < report->minimizer.value) report->minimizer = report->candidates[i];
  report->maximizer = greatest_candidate(report->bernstein);
  map_point(vertices, report->maximizer.point, report->maximizer.position);
  report->verdict = filtered_verdict(report->bernstein);
  /* A computed minimum that contradicts a certain verdict has lost its sign: exact arithmetic gives both. */
  if (report->verdict == HL_VALID && !(report->minimizer.value > 0)) report->verdict = HL_UNDECIDED;

  int exponent = jacdet_exponent(&edges);
  report->exponent = exponent_left(report, exponent);
  for (int f = 0; f < HL_FACES; ++f) {
    hl_face_report *face = &report->faces[f];
    face->quartic_exponent = scaled_back(face->quartic, HL_QUARTIC, face->quartic_exponent + 3 * exponent);
  }
  return HL_OK;
}

hl_status hl_boundary_minimum(const double vertices[24], hl_variant variant, hl_minimum *minimum) {
  if (!all_finite(vertices, HL_COORDINATES)) return HL_NOT_FINITE;
  edge_vectors edges;
  double bernstein[27];
  scaled_edge_vectors(vertices, &edges);
  jacdet_bernstein(&edges, bernstein);
  minimum->minimizer = least_candidate(bernstein, variant);
  map_point(vertices, minimum->minimizer.point, minimum->minimizer.position);
  minimum->exponent = scaled_back(&minimum->minimizer.value, 1, jacdet_exponent(&edges));
  return HL_OK;
}

hl_status hl_decide(const double vertices[24], hl_verdict *verdict) {
  if (!all_finite(vertices, HL_COORDINATES)) return HL_NOT_FINITE;
  edge_vectors edges;
  double bernstein[27];
  scaled_edge_vectors(vertices, &edges);
  jacdet_bernstein(&edges, bernstein);
  *verdict = filtered_verdict(bernstein);
  return HL_OK;
}
