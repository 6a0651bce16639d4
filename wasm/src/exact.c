/* Algorithm 1 in integers, from what is cheap to what is dear: vertices, edges, then faces that the criterion of the filter leaves
   open. docs/algorithm.md 7. */
#include "exact.h"
#include "bernstein.h"
#include "error_bounds.h"
#include "exact_face.h"
#include "exact_jacdet.h"
#include "face.h"
#include "filter.h"
#include "topology.h"

/* A task is tried with little memory, and begun again with more where that is full. The integers of an element whose coordinates
   have B bits on each axis have 3B, D has 6B, and numbers in chains of remainders up to 66 times as many, (X3): ordinary coordinates need
   a quarter of the first at most for verdicts, and nothing is longer than the last has room for. */
enum { LITTLE = 5000, MORE = 40000, MOST = 655360 }; /* limbs of four bytes */

typedef void exact_task(workspace *w, void *query);

static bool run_in(uint32_t *limbs, size_t capacity, exact_task *task, void *query, exact_cost *cost) {
  workspace w = {.limbs = limbs, .capacity = capacity};
  task(&w, query);
  if (cost) {
    cost->multiplications += w.multiplications;
    cost->products += w.products;
  }
  return !w.is_full;
}

/* Functions of their own, so that a stack holds only the memory that is used. */
#define NOT_INLINE __attribute__((noinline))

NOT_INLINE static bool run_with_little(exact_task *task, void *query, exact_cost *cost) {
  uint32_t limbs[LITTLE];
  return run_in(limbs, LITTLE, task, query, cost);
}
NOT_INLINE static bool run_with_more(exact_task *task, void *query, exact_cost *cost) {
  uint32_t limbs[MORE];
  return run_in(limbs, MORE, task, query, cost);
}
NOT_INLINE static bool run_with_most(exact_task *task, void *query, exact_cost *cost) {
  uint32_t limbs[MOST];
  return run_in(limbs, MOST, task, query, cost);
}

/* Coordinates on one axis of which the largest is 2^200 times the smallest: little memory would be tried in vain. */
enum { WIDE = 200 };

static bool has_wide_axis(const double vertices[24]) {
  for (int axis = 0; axis < 3; ++axis) {
    int least = INT32_MAX, greatest = INT32_MIN;
    for (int i = axis; i < HL_COORDINATES; i += 3) {
      if (vertices[i] == 0) continue;
      const int exponent = binary_exponent(vertices[i]);
      if (exponent < least) least = exponent;
      if (exponent > greatest) greatest = exponent;
    }
    if (least <= greatest && greatest - least > WIDE) return true;
  }
  return false;
}

static void run(exact_task *task, const double vertices[24], void *query, exact_cost *cost) {
  if (cost) *cost = (exact_cost){0, 0};
  if (!has_wide_axis(vertices) && (run_with_little(task, query, cost) || run_with_more(task, query, cost))) return;
  if (!run_with_most(task, query, cost))
    __builtin_trap(); /* no answer rather than a wrong one; (X3) says that it is none */
}

bool is_zero_at_sight(const double vertices[24]) {
  for (int v = 1; v < HL_VERTICES; ++v)
    for (int u = 0; u < v; ++u) {
      const double *p = vertices + 3 * v, *q = vertices + 3 * u;
      if (p[0] != q[0] || p[1] != q[1] || p[2] != q[2]) continue;
      int differing = 0;
      for (int axis = 0; axis < 3; ++axis) differing += vertex_reference[v][axis] != vertex_reference[u][axis];
      if (differing < 3) return true; /* the four diagonals of the cube say nothing */
    }
  return false;
}

/* The coefficients of an edge from its lower to its upper end. */
static void exact_edge(const exact_jacdet *jacdet, int edge, integer q[3]) {
  const int middle = edge_bernstein[edge], stride = axis_stride[edge_table[edge].axis];
  for (int i = 0; i < 3; ++i) q[i] = jacdet->bernstein[middle + (i - 1) * stride];
}

static void exact_face_of(const exact_jacdet *jacdet, int face, exact_face *out) {
  for (int i = 0; i < HL_FACE_BERNSTEIN; ++i) out->beta[i / 3][i % 3] = jacdet->bernstein[face_coefficients[face][i]];
}

/* Smaller doubles than this, beside a largest one in [1/2, 1), keep their sign and nothing else. */
enum { LEAST_POWER = -1000 };

static double in_unit(scaled_double x, int unit) {
  if (x.mantissa == 0) return 0;
  const int power = x.exponent - unit;
  if (power >= LEAST_POWER) return times_power_of_two(x.mantissa, power);
  return x.mantissa < 0 ? -0x1p-1000 : 0x1p-1000;
}

/* The face's coefficients as doubles times 2^unit, the largest of magnitude in [1/2, 1), each of its exact sign. */
static int face_in_doubles(const workspace *w, const exact_face *face, double beta[9]) {
  scaled_double rounded[9];
  int unit = INT32_MIN;
  for (int i = 0; i < 9; ++i) {
    rounded[i] = rounded_integer(w, face->beta[i / 3][i % 3], 0);
    if (rounded[i].mantissa != 0 && rounded[i].exponent > unit) unit = rounded[i].exponent;
  }
  for (int i = 0; i < 9; ++i) beta[i] = in_unit(rounded[i], unit);
  return unit;
}

typedef struct verdict_query {
  const double *vertices, *bernstein;
  hl_verdict verdict;
} verdict_query;

/* True if all values inside an edge with positive ends are positive. */
static bool is_positive_edge(workspace *w, const integer q[3]) {
  return !is_negative(q[1]) || integer_compare_products(w, q[1], q[1], q[0], q[2]) < 0;
}

static bool is_positive_face(workspace *w, const exact_face *face) {
  double beta[HL_FACE_BERNSTEIN];
  face_in_doubles(w, face, beta);
  return !face_can_be_lower(beta, 0) || exact_face_sign(w, face) > 0;
}

static void decide(workspace *w, void *query) {
  verdict_query *q = query;
  q->verdict = HL_INVALID;
  for (int v = 0; v < HL_VERTICES; ++v)
    if (!(q->bernstein[vertex_index(v)] > CORNER_ERROR) && exact_vertex_sign(w, q->vertices, v) <= 0) return;
  exact_jacdet jacdet;
  exact_bernstein(w, q->vertices, &jacdet);
  const size_t mark = w->used;
  for (int e = 0; e < HL_EDGES; ++e) {
    integer coefficients[3];
    exact_edge(&jacdet, e, coefficients);
    if (!is_positive_edge(w, coefficients)) return;
    w->used = mark;
  }
  for (int f = 0; f < HL_FACES; ++f) {
    exact_face face;
    exact_face_of(&jacdet, f, &face);
    if (!is_positive_face(w, &face)) return;
    w->used = mark;
  }
  q->verdict = HL_VALID;
}

hl_verdict exact_verdict(const double vertices[24], const double bernstein[27], exact_cost *cost) {
  verdict_query query = {vertices, bernstein, HL_INVALID};
  run(decide, vertices, &query, cost);
  return query.verdict;
}

static bool is_below(workspace *w, integer numerator, integer denominator, const least_value *least) {
  return integer_compare_products(w, numerator, least->denominator, least->numerator, denominator) < 0;
}

/* The vertex of an upward parabola inside an edge, if there is one: its place, and its value numerator / denominator. */
static bool edge_extremum(workspace *w, const integer q[3], int edge, hl_candidate *candidate, least_value *value) {
  const integer fall = integer_difference(w, q[0], q[1]), rise = integer_difference(w, q[2], q[1]);
  if (!is_positive(fall) || !is_positive(rise)) return false;
  value->numerator = integer_difference(w, integer_product(w, q[0], q[2]), integer_product(w, q[1], q[1]));
  value->denominator = integer_sum(w, fall, rise);
  const unsigned char *start = vertex_reference[edge_table[edge].from];
  *candidate = (hl_candidate){.kind = HL_EDGE, .id = edge, .point = {start[0], start[1], start[2]}};
  candidate->point[edge_table[edge].axis] = inside_unit_interval(w, fall, value->denominator, 0);
  return true;
}

static void lower_to_edge(workspace *w, const integer q[3], int edge, least_value *least, hl_candidate *minimizer) {
  hl_candidate candidate;
  least_value value;
  /* A value on the edge is no lower than its middle coefficient, if that is the least. */
  if (!is_below(w, q[1], integer_of(w, 1), least) || !edge_extremum(w, q, edge, &candidate, &value)) return;
  if (!is_below(w, value.numerator, value.denominator, least)) return;
  least->numerator = value.numerator;
  least->denominator = value.denominator;
  *minimizer = candidate;
}

/* Room above the minimum for its rounding and that of coefficients, in units of a face's largest: (B2) with a bound that is too high
   holds for one that is not. */
#define ROUNDED_UP 0x1p-50

/* True if the face is certainly nowhere below `least`: (B2). `roots` become points where it may
   be. */
static bool is_no_lower(workspace *w, const exact_face *face, const least_value *least, face_solution *roots) {
  const integer one = integer_of(w, 1);
  bool is_lower = false;
  for (int i = 0; i < 9 && !is_lower; ++i) is_lower = is_below(w, face->beta[i / 3][i % 3], one, least);
  if (!is_lower) return true;
  double beta[HL_FACE_BERNSTEIN];
  const int unit = face_in_doubles(w, face, beta);
  /* A coefficient is below it, and corners are not: it is of no greater magnitude than the largest. */
  const double bound = in_unit(rounded_quotient(w, least->numerator, least->denominator, 0), unit);
  if (!face_can_be_lower(beta, bound + ROUNDED_UP)) return true;
  find_kept_roots(beta, roots);
  return false;
}

static void lower_to_face(workspace *w, const exact_face *face, int id, least_value *least, hl_candidate *minimizer) {
  face_solution solution;
  double roots[HL_MAX_ROOTS];
  if (is_no_lower(w, face, least, &solution)) return;
  for (int r = 0; r < solution.root_count; ++r) roots[r] = solution.roots[r].t;
  const int sign = is_negative(least->numerator) ? -1 : exact_face_sign(w, face);
  if (is_zero(least->numerator) && sign >= 0) return;
  if (sign == 0) {
    exact_face_touch(w, face, roots, solution.root_count, least);
    least->numerator = zero;
  } else if (!exact_face_lowers(w, face, roots, solution.root_count, least)) {
    return;
  }
  *minimizer = (hl_candidate){.kind = HL_FACE, .id = id};
  minimizer->point[face_table[id].axis] = face_table[id].side;
  minimizer->point[face_table[id].s] = least->s;
  minimizer->point[face_table[id].t] = least->t;
}

static void keep_least(workspace *w, size_t mark, least_value *least) {
  integer kept[2] = {least->numerator, least->denominator};
  integer_keep(w, mark, kept, 2);
  least->numerator = kept[0];
  least->denominator = kept[1];
}

static hl_candidate candidate_at(int vertex) {
  const unsigned char *r = vertex_reference[vertex];
  return (hl_candidate){.kind = HL_VERTEX, .id = vertex, .point = {r[0], r[1], r[2]}};
}

/* The exponent of four times the coefficients. */
static int exponent_of(const exact_jacdet *jacdet) { return jacdet->exponent - 2; }

/* The vertex candidate is the first of the least, an edge or a face takes its place where it is lower. */
static void minimize(workspace *w, const exact_jacdet *jacdet, exact_minimum *out, scaled_double *edge_minimum) {
  const integer *b = jacdet->bernstein;
  const int exponent = exponent_of(jacdet);
  int first = 0;
  for (int v = 1; v < HL_VERTICES; ++v)
    if (integer_compare(w, b[vertex_index(v)], b[vertex_index(first)]) < 0) first = v;
  out->minimizer = candidate_at(first);
  out->corner_minimum = rounded_integer(w, b[vertex_index(first)], exponent);
  least_value least = {.numerator = b[vertex_index(first)], .denominator = integer_of(w, 1)};
  const size_t mark = w->used;
  for (int e = 0; e < HL_EDGES; ++e) {
    integer q[3];
    exact_edge(jacdet, e, q);
    lower_to_edge(w, q, e, &least, &out->minimizer);
    keep_least(w, mark, &least);
  }
  if (edge_minimum) *edge_minimum = rounded_quotient(w, least.numerator, least.denominator, exponent);
  for (int f = 0; f < HL_FACES; ++f) {
    exact_face face;
    exact_face_of(jacdet, f, &face);
    lower_to_face(w, &face, f, &least, &out->minimizer);
    keep_least(w, mark, &least);
  }
  out->minimum = rounded_quotient(w, least.numerator, least.denominator, exponent);
}

typedef struct minimum_query {
  const double *vertices;
  exact_minimum *minimum;
} minimum_query;

static void find_minimum(workspace *w, void *query) {
  const minimum_query *q = query;
  exact_jacdet jacdet;
  exact_bernstein(w, q->vertices, &jacdet);
  minimize(w, &jacdet, q->minimum, NULL);
}

void find_exact_minimum(const double vertices[24], exact_minimum *minimum, exact_cost *cost) {
  minimum_query query = {vertices, minimum};
  run(find_minimum, vertices, &query, cost);
}

/* Sixteen times all coefficients, over 2^(exponent - 4). */
static void sixteenths(workspace *w, const exact_jacdet *jacdet, integer coefficients[27]) {
  for (int i = 0; i < HL_BERNSTEIN; ++i) coefficients[i] = integer_shifted(w, jacdet->bernstein[i], 2);
  coefficients[CUBE_CENTRE] = exact_cube_centre(w, jacdet);
}

static integer least_integer(const workspace *w, const integer *values, int count) {
  integer least = values[0];
  for (int i = 1; i < count; ++i)
    if (integer_compare(w, values[i], least) < 0) least = values[i];
  return least;
}

/* All coefficients as doubles, in one unit and each of its own size, and the least of them. */
static void put_coefficients(const workspace *w, const integer coefficients[27], int exponent, exact_values *out) {
  int bits = 0;
  for (int i = 0; i < HL_BERNSTEIN; ++i)
    if (integer_bits(w, coefficients[i]) > bits) bits = integer_bits(w, coefficients[i]);
  out->unit = bits == 0 ? 0 : exponent + bits;
  for (int i = 0; i < HL_BERNSTEIN; ++i) {
    out->coefficients[i] = rounded_integer(w, coefficients[i], exponent);
    out->bernstein[i] = in_unit(out->coefficients[i], out->unit);
  }
  out->error = bits == 0 ? 0 : UNIT_ROUNDOFF;
  out->bernstein_minimum = rounded_integer(w, least_integer(w, coefficients, HL_BERNSTEIN), exponent);
}

/* The abscissae of the Gauss rules on [0,1], (1 -+ 1/sqrt(3))/2 and (1 -+ sqrt(3/5))/2, as doubles are integers over 2^56. */
enum { GAUSS_BITS = 56 };
static const int64_t gauss_2[2] = {15227561361486732, 56830032676441200},
                     gauss_3[3] = {8121010851296992, (int64_t)1 << (GAUSS_BITS - 1), 63936583186630944};
static const int64_t half[1] = {1};

/* The least jacdet at all points whose coordinates are among `abscissae` over 2^bits: axis after axis, coefficients become values. */
static scaled_double least_on_grid(workspace *w, const integer coefficients[27], const int64_t *abscissae, int count,
                                   int bits, int exponent) {
  const size_t mark = w->used;
  integer values[27];
  for (int i = 0; i < HL_BERNSTEIN; ++i) values[i] = coefficients[i];
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 9; ++row) {
      const int stride = axis_stride[axis], first = first_of_row(axis, row);
      const integer q[3] = {values[first], values[first + stride], values[first + 2 * stride]};
      for (int p = 0; p < 3; ++p) {
        if (p >= count) {
          values[first + p * stride] = values[first]; /* points that are not there are the first once more */
          continue;
        }
        const integer n = integer_of(w, abscissae[p]), rest = integer_of(w, ((int64_t)1 << bits) - abscissae[p]),
                      outer = integer_sum(w, integer_product(w, rest, q[0]), integer_product(w, n, q[1])),
                      inner = integer_sum(w, integer_product(w, rest, q[1]), integer_product(w, n, q[2]));
        values[first + p * stride] = integer_sum(w, integer_product(w, rest, outer), integer_product(w, n, inner));
      }
    }
  const scaled_double least = rounded_integer(w, least_integer(w, values, HL_BERNSTEIN), exponent - 6 * bits);
  w->used = mark;
  return least;
}

typedef struct values_query {
  const double *vertices;
  exact_values *values;
} values_query;

static void find_values(workspace *w, void *query) {
  const values_query *q = query;
  exact_values *out = q->values;
  exact_jacdet jacdet;
  exact_bernstein(w, q->vertices, &jacdet);
  const size_t mark = w->used;
  minimize(w, &jacdet, &out->boundary, &out->edge_minimum);
  out->edge_count = 0;
  for (int v = 0; v < HL_VERTICES; ++v) {
    out->vertex_candidates[v] = candidate_at(v);
    out->vertices[v] = rounded_integer(w, jacdet.bernstein[vertex_index(v)], exponent_of(&jacdet));
  }
  for (int e = 0; e < HL_EDGES; ++e) {
    integer coefficients[3];
    least_value value;
    w->used = mark;
    exact_edge(&jacdet, e, coefficients);
    if (!edge_extremum(w, coefficients, e, &out->edge_candidates[out->edge_count], &value)) continue;
    out->on_edges[out->edge_count++] = rounded_quotient(w, value.numerator, value.denominator, exponent_of(&jacdet));
  }
  w->used = mark;
  integer coefficients[HL_BERNSTEIN];
  const int exponent = jacdet.exponent - 4;
  sixteenths(w, &jacdet, coefficients);
  put_coefficients(w, coefficients, exponent, out);
  out->gauss_2 = least_on_grid(w, coefficients, gauss_2, 2, GAUSS_BITS, exponent);
  out->gauss_3 = least_on_grid(w, coefficients, gauss_3, 3, GAUSS_BITS, exponent);
  out->centre = least_on_grid(w, coefficients, half, 1, 1, exponent);
  exact_middle_columns(w, q->vertices, out->columns);
}

void find_exact_values(const double vertices[24], exact_values *values, exact_cost *cost) {
  values_query query = {vertices, values};
  run(find_values, vertices, &query, cost);
}

typedef struct collapse_query {
  const double *vertices;
  bool is_collapsed;
} collapse_query;

/* The cube's centre follows from the others. */
static void find_collapse(workspace *w, void *query) {
  collapse_query *q = query;
  exact_jacdet jacdet;
  exact_bernstein(w, q->vertices, &jacdet);
  q->is_collapsed = true;
  for (int i = 0; i < HL_BERNSTEIN; ++i) q->is_collapsed = q->is_collapsed && is_zero(jacdet.bernstein[i]);
}

bool is_collapsed(const double vertices[24]) {
  collapse_query query = {vertices, false};
  run(find_collapse, vertices, &query, NULL);
  return query.is_collapsed;
}

typedef struct volume_query {
  const double *vertices;
  scaled_double volume;
} volume_query;

static void integrate(workspace *w, void *query) {
  volume_query *q = query;
  q->volume = exact_volume(w, q->vertices);
}

scaled_double find_exact_volume(const double vertices[24]) {
  volume_query query = {.vertices = vertices};
  run(integrate, vertices, &query, NULL);
  return query.volume;
}
