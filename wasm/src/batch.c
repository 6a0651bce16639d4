/* Batches: blocks of cells through the fast stage, what it leaves open through the scalar code one by one, in constant
   memory (docs/algorithm.md 10). */
#include "batch.h"
#include "bernstein.h"
#include "candidates.h"
#include "exact.h"
#include "face.h"
#include "filter.h"
#include "hints.h"
#include "report.h"
#include "topology.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Memory for the minima of a block's cells; the minimizers are the caller's, or none. */
typedef struct minima_lists {
  double *minima, *minimizers, *corner_minima;
  int16_t *exponents;
} minima_lists;

/* One block: its cells side by side, and what is known of them. */
typedef struct block {
  double copied[HL_BLOCK * HL_COORDINATES]; /* readable to its end, whatever is in the part that is not used */
  const double *hexahedra;
  int count;
  uint8_t verdicts[HL_BLOCK], statuses[HL_BLOCK], is_exact[HL_BLOCK];
  double open[HL_BLOCK * HL_COORDINATES];
  lane_minima lanes;
  bool has_lanes; /* the lanes' entries are those of the cells */
  lane_volumes volumes;
  lane_nearest_volumes nearest;
  minima_lists out;
  double minima[HL_BLOCK], corner_minima[HL_BLOCK];
  int16_t exponents[HL_BLOCK];
} block;

static const double not_a_cell[HL_COORDINATES] = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN,
                                                  NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};

/* Copies the cells' points next to each other. */
static void gather(const hl_cells *cells, size_t first, block *b) {
  const size_t point_count = cells->coordinate_count / 3;
  for (int c = 0; c < b->count; ++c) {
    const uint32_t *indices = cells->indices + 8 * (first + (size_t)c);
    bool has_points = true;
    for (int v = 0; v < 8; ++v) has_points = has_points && indices[v] < point_count;
    if (!has_points) {
      b->statuses[c] = HL_NO_SUCH_POINT;
      memcpy(b->copied + 24 * c, not_a_cell, sizeof not_a_cell);
      continue;
    }
    for (int v = 0; v < 8; ++v)
      memcpy(b->copied + 24 * c + 3 * v, cells->coordinates + 3 * (size_t)indices[v], 3 * sizeof(double));
  }
}

/* A whole block of plain coordinates is read where it is. */
static void fill_block(const hl_cells *cells, size_t first, int count, block *b) {
  b->count = count;
  memset(b->statuses, HL_OK, sizeof b->statuses);
  b->hexahedra = b->copied;
  if (cells->indices) gather(cells, first, b);
  else if (count == HL_BLOCK) b->hexahedra = cells->coordinates + 24 * first;
  else memcpy(b->copied, cells->coordinates + 24 * first, (size_t)count * HL_COORDINATES * sizeof(double));
}

/* A cell whose coordinates are not finite, or that has none. */
static void leave_unanswered(block *b, int c) {
  b->verdicts[c] = HL_UNANSWERED;
  b->is_exact[c] = 0;
  if (b->statuses[c] == HL_OK) b->statuses[c] = HL_NOT_FINITE;
}

/* The coefficients that the lanes have computed. */
static void bernstein_from_lanes(const lane_kernels *kernels, const lane_minima *lanes, int c, double bernstein[27]) {
  const int width = kernels->width, lane = c & (width - 1);
  const double *of_group = lanes->bernstein + 27 * (c - lane) + lane;
  for (int i = 0; i < HL_BERNSTEIN; ++i) bernstein[i] = bernstein_factor[i] * of_group[i * width] + 0.0;
}

/* hl_decide, from what the lanes know in doubles of the open cell `c`, which is cell `cell` of the block. */
static void decide_cell(const lane_kernels *kernels, bool asks_exact, int c, int cell, block *b) {
  const double *vertices = b->hexahedra + 24 * cell;
  const int state = kernels ? b->lanes.state[c] : 0;
  if (state & LANE_USABLE && state & (LANE_VALID | LANE_INVALID)) {
    b->verdicts[cell] = state & LANE_VALID ? HL_VALID : HL_INVALID;
    return;
  }
  double bernstein[27];
  if (state & LANE_USABLE) {
    bernstein_from_lanes(kernels, &b->lanes, c, bernstein);
  } else {
    if (!all_finite(vertices, HL_COORDINATES)) {
      leave_unanswered(b, cell);
      return;
    }
    edge_vectors edges;
    scaled_edge_vectors(vertices, &edges);
    jacdet_bernstein(&edges, bernstein);
  }
  hl_verdict verdict;
  b->is_exact[cell] = (!asks_exact && has_open_corner(bernstein)) || !is_settled_by_filter(bernstein, &verdict);
  if (b->is_exact[cell]) verdict = is_zero_at_sight(vertices) ? HL_INVALID : exact_verdict(vertices, bernstein, NULL);
  b->verdicts[cell] = (uint8_t)verdict;
}

/* True if one of eight bytes is 0. */
static bool has_unanswered(const uint8_t *verdicts) {
  uint64_t bytes;
  memcpy(&bytes, verdicts, sizeof bytes);
  return ((bytes - 0x0101010101010101u) & ~bytes & 0x8080808080808080u) != 0;
}

/* Floats, then doubles for those left open together, then one by one. Cells with zeros at sight
   need no coefficients, those with an open corner no filter, unless it is asked if doubles would
   have decided. */
static void decide_block(const lane_kernels *kernels, bool asks_exact, block *b, batch_stages *stages) {
  int open[HL_BLOCK], open_count = 0;
  b->has_lanes = false;
  memset(b->verdicts, HL_UNANSWERED, HL_BLOCK);
  memset(b->is_exact, 0, HL_BLOCK);
  if (kernels) kernels->decide(b->hexahedra, b->count, b->verdicts);
  for (int c = 0; c < b->count; c += 8) {
    if (!has_unanswered(b->verdicts + c)) continue;
    for (int d = c; d < c + 8 && d < b->count; ++d) {
      if (b->verdicts[d] != HL_UNANSWERED) continue;
      if (!asks_exact && is_zero_at_sight(b->hexahedra + 24 * d) && all_finite(b->hexahedra + 24 * d, HL_COORDINATES))
        b->verdicts[d] = HL_INVALID;
      else open[open_count++] = d;
    }
  }
  stages->after_lanes += (size_t)open_count;
  if (kernels && open_count > 0) {
    for (int i = 0; i < open_count; ++i)
      memcpy(b->open + 24 * i, b->hexahedra + 24 * open[i], HL_COORDINATES * sizeof(double));
    kernels->corners(b->open, open_count, &b->lanes);
  }
  for (int i = 0; i < open_count; ++i) decide_cell(kernels, asks_exact, i, open[i], b);
}

static hl_candidate first_least_vertex(const double bernstein[27]) {
  int least = 0;
  for (int v = 1; v < HL_VERTICES; ++v)
    if (bernstein[vertex_index(v)] < bernstein[vertex_index(least)]) least = v;
  return vertex_candidate(bernstein, least);
}

enum { EDGE_BITS = (1 << HL_EDGES) - 1 };

/* Edges and faces whose middle coefficient is below a bound. */
static uint32_t middles_below(const double bernstein[27], double bound) {
  uint32_t bits = 0;
  for (int e = 0; e < HL_EDGES; ++e) bits |= (uint32_t)(bernstein[edge_bernstein[e]] < bound) << e;
  for (int f = 0; f < HL_FACES; ++f) bits |= (uint32_t)(bernstein[face_middle(f)] < bound) << (HL_EDGES + f);
  return bits;
}

/* The faces that have one of these bits. */
static uint32_t faces_with(uint32_t below) {
  uint32_t faces = 0;
  for (int f = 0; f < HL_FACES; ++f) faces |= (uint32_t)((below & face_middle_bits[f]) != 0) << f;
  return faces;
}

/* The candidate of hl_boundary_minimum given the least vertex: passed over is only what cannot be lower, (B1) and (B2). */
static hl_candidate least_from(hl_candidate least, const double bernstein[27]) {
  const uint32_t below = middles_below(bernstein, least.value);
  for (uint32_t bits = below & EDGE_BITS; bits; bits &= bits - 1)
    edge_candidate(bernstein, __builtin_ctz(bits), least.value, &least);
  for (uint32_t bits = faces_with(below); bits; bits &= bits - 1) {
    const int f = __builtin_ctz(bits);
    double beta[HL_FACE_BERNSTEIN];
    face_bernstein(bernstein, f, beta);
    if (!face_can_be_lower(beta, least.value)) continue;
    face_solution solution;
    find_kept_roots(beta, &solution);
    for (int r = 0; r < solution.root_count; ++r)
      if (solution.values[r] < least.value) least = face_candidate(f, &solution, r);
  }
  return least;
}

static void put_minimizer(block *b, int c, const double point[3]) {
  if (b->out.minimizers) memcpy(b->out.minimizers + 3 * c, point, 3 * sizeof *point);
}

/* Powers of two that can lie between two doubles in a unit in their middle. */
enum { MOST_APART = 2000 };

/* The minimum, and the least corner in the same unit: 1 if both are normal doubles then, else between them, or that of the minimum
   alone if they are too far apart. */
static void put_values(scaled_double minimum, scaled_double corner, block *b, int c) {
  int unit = 0;
  if (!is_normal_after_scaling(minimum.mantissa, minimum.exponent) ||
      !is_normal_after_scaling(corner.mantissa, corner.exponent)) {
    const int apart = corner.exponent - minimum.exponent;
    unit = minimum.mantissa == 0 ? corner.exponent : minimum.exponent;
    if (minimum.mantissa != 0 && corner.mantissa != 0 && apart >= -MOST_APART && apart <= MOST_APART) unit += apart / 2;
  }
  b->out.exponents[c] = (int16_t)unit;
  b->out.minima[c] = in_normal_units(minimum, unit);
  b->out.corner_minima[c] = in_normal_units(corner, unit);
}

/* The minimum from the coordinates alone, by integers if doubles are not accurate enough. */
static void minimum_alone(block *b, int c) {
  const double *vertices = b->hexahedra + 24 * c;
  if (!all_finite(vertices, HL_COORDINATES)) {
    leave_unanswered(b, c);
    put_minimizer(b, c, not_a_cell);
    b->out.minima[c] = b->out.corner_minima[c] = NAN;
    b->out.exponents[c] = 0;
    return;
  }
  edge_vectors edges;
  double bernstein[27];
  scaled_edge_vectors(vertices, &edges);
  jacdet_bernstein(&edges, bernstein);
  hl_candidate vertex = first_least_vertex(bernstein), least = least_from(vertex, bernstein);
  hl_verdict verdict;
  b->is_exact[c] = !is_settled_by_doubles(bernstein, greatest_permanent(&edges), least.value, &verdict);
  if (b->is_exact[c]) {
    exact_minimum exact;
    find_exact_minimum(vertices, &exact, NULL);
    verdict = exact.minimum.mantissa > 0 ? HL_VALID : HL_INVALID;
    put_minimizer(b, c, exact.minimizer.point);
    put_values(exact.minimum, exact.corner_minimum, b, c);
  } else {
    double values[2] = {least.value, vertex.value};
    b->out.exponents[c] = (int16_t)scaled_back(values, 2, jacdet_exponent(&edges));
    b->out.minima[c] = values[0];
    b->out.corner_minima[c] = values[1];
    put_minimizer(b, c, least.point);
  }
  b->verdicts[c] = (uint8_t)verdict;
}

/* True if a value, `scaled` times a power of two, has not lost bits below the normal doubles. */
static bool is_whole(double value, double scaled) { return scaled == 0 || fabs(value) >= DBL_MIN; }

/* The least corner stands there as the minimum, with its verdict: lowers it to the boundary minimum, by the coefficients that the
   lanes have computed, which are accurate. Returns false where doubles leave the verdict open or have no room for a value. */
static bool lower_minimum(const lane_kernels *kernels, block *b, int c) {
  const lane_minima *lanes = &b->lanes;
  double bernstein[27];
  bernstein_from_lanes(kernels, lanes, c, bernstein);
  hl_candidate least = least_from(vertex_candidate(bernstein, lanes->vertex[c]), bernstein);
  hl_verdict verdict = b->verdicts[c];
  if (!(lanes->state[c] & (LANE_VALID | LANE_INVALID)) && !is_settled_by_filter(bernstein, &verdict)) return false;
  if (verdict == HL_VALID && !(least.value > 0)) return false;
  b->verdicts[c] = (uint8_t)verdict;
  b->out.minima[c] = least.value * lanes->unit[c];
  put_minimizer(b, c, least.point);
  return is_whole(b->out.minima[c], least.value) &&
         is_whole(b->out.corner_minima[c], bernstein[vertex_index(lanes->vertex[c])]);
}

/* The least corners of the block's cells `from` to `to`, as if all were settled. */
static void put_corners(block *b, int from, int to) {
  const lane_minima *lanes = &b->lanes;
  const size_t count = (size_t)(to - from);
  memcpy(b->out.minima + from, lanes->least + from, count * sizeof(double));
  memcpy(b->out.corner_minima + from, lanes->least + from, count * sizeof(double));
  memset(b->out.exponents + from, 0, count * sizeof(int16_t));
  for (int c = from; c < to; ++c) b->verdicts[c] = lanes->state[c] & LANE_VALID ? HL_VALID : HL_INVALID;
  for (int c = from; c < to && b->out.minimizers; ++c) put_minimizer(b, c, vertex_point[lanes->vertex[c]]);
}

/* The first of the cells from `c` on that lacks this bit, or `end`. */
static int first_without(const unsigned char *state, int bit, int c, int end) {
  for (uint64_t eight; c + 8 <= end; c += 8) {
    memcpy(&eight, state + c, sizeof eight);
    if (~eight & 0x0101010101010101u * (unsigned)bit) break;
  }
  while (c < end && state[c] & bit) ++c;
  return c;
}

/* Minima in doubles side by side, then one by one. */
static void minima_of_block(const lane_kernels *kernels, block *b, batch_stages *stages) {
  const lane_minima *lanes = &b->lanes;
  memset(b->is_exact, 0, HL_BLOCK);
  b->has_lanes = kernels != NULL;
  if (kernels) kernels->corners(b->hexahedra, b->count, &b->lanes);
  for (int from = 0, to; from < b->count; from = to + 1) {
    to = kernels ? first_without(lanes->state, LANE_USABLE, from, b->count) : from;
    put_corners(b, from, to);
    for (int c = from; (c = first_without(lanes->state, LANE_SETTLED, c, to)) < b->count && c <= to; ++c) {
      ++stages->after_lanes;
      if (c < to && lanes->state[c] & LANE_ACCURATE && lower_minimum(kernels, b, c)) continue;
      minimum_alone(b, c);
    }
  }
}

static bool asks_for_minima(const hl_batch *batch) {
  return batch->minima || batch->minimizers || batch->corner_minima || batch->exponents || batch->relative_minima;
}

/* A list of the caller's from the block's first cell on, or room in the block for what was not asked for. */
#define OR_ROOM(list, from) (batch->list ? batch->list + (from) : b->list)

static void choose_lists(const hl_batch *batch, size_t first, block *b) {
  b->out = (minima_lists){.minima = OR_ROOM(minima, first),
                          .minimizers = batch->minimizers ? batch->minimizers + 3 * first : NULL,
                          .corner_minima = OR_ROOM(corner_minima, first),
                          .exponents = OR_ROOM(exponents, first)};
}

/* class_of, which looks for a corner that is certainly positive first. */
static hl_class class_in_block(const block *b, int c) {
  enum { MIXED = LANE_USABLE | LANE_POSITIVE };
  if (b->verdicts[c] == HL_VALID) return HL_CLASS_VALID;
  if (b->has_lanes && (b->lanes.state[c] & MIXED) == MIXED) return HL_CLASS_INVALID;
  return class_of(b->hexahedra + 24 * c, b->verdicts[c]);
}

/* find_volume, in the lanes where they tell. */
static double volume_in_block(const lane_kernels *kernels, const block *b, int c, int *exponent) {
  *exponent = 0;
  if (kernels && b->nearest.is_found[c]) return b->nearest.volume[c];
  const scaled_double number = find_volume(b->hexahedra + 24 * c);
  double volume = number.mantissa;
  *exponent = scaled_back(&volume, 1, number.exponent);
  return volume;
}

static bool asks_for_volumes(const hl_batch *batch) {
  return batch->volumes || batch->volume_exponents || batch->relative_minima;
}

/* The lists of one cell beyond its verdict and minimum. */
static void put_details(const lane_kernels *kernels, const hl_batch *batch, const block *b, int c, size_t cell) {
  const double *vertices = b->hexahedra + 24 * c;
  const bool is_answered = b->statuses[c] == HL_OK;
  if (batch->classes) batch->classes[cell] = is_answered ? (uint8_t)class_in_block(b, c) : 0;
  if (batch->accepted_by) batch->accepted_by[cell] = is_answered ? (uint16_t)checks_that_accept(vertices) : 0;
  if (!asks_for_volumes(batch)) return;
  int exponent = 0;
  const double volume = is_answered ? volume_in_block(kernels, b, c, &exponent) : NAN;
  if (batch->volumes) batch->volumes[cell] = volume;
  if (batch->volume_exponents) batch->volume_exponents[cell] = (int16_t)exponent;
  if (batch->relative_minima)
    batch->relative_minima[cell] =
        is_answered ? relative_minimum(b->out.minima[c], b->out.exponents[c], volume, exponent) : NAN;
}

/* About the relative minima of the block's cells; all that is not told is NaN. */
static void put_relative_minima(const lane_kernels *kernels, bool leaves_valid, block *b, float *list) {
  int cells[HL_BLOCK], count = 0;
  for (int c = 0; c < b->count; ++c) {
    list[c] = NAN;
    if (b->verdicts[c] != HL_UNANSWERED && !(leaves_valid && b->verdicts[c] == HL_VALID)) cells[count++] = c;
  }
  if (!kernels || count == 0) return;
  const bool is_whole = count == b->count;
  for (int i = 0; i < count && !is_whole; ++i)
    memcpy(b->open + 24 * i, b->hexahedra + 24 * cells[i], HL_COORDINATES * sizeof(double));
  kernels->volumes(is_whole ? b->hexahedra : b->open, count, &b->volumes);
  for (int i = 0; i < count; ++i)
    if (b->out.exponents[cells[i]] == 0)
      list[cells[i]] = relative_minimum_about(b->out.minima[cells[i]], b->volumes.twelvefold[i], b->volumes.size[i]);
}

static void widen_one_by_one(const double *hexahedra, int count, double box[6]) {
  for (int i = 0; i < HL_COORDINATES * count; ++i) {
    box[i % 3] = smaller(box[i % 3], hexahedra[i]);
    box[3 + i % 3] = larger(box[3 + i % 3], hexahedra[i]);
  }
}

static void put_hints(const lane_kernels *kernels, const batch_hints *hints, size_t first, block *b) {
  if (hints->box) (kernels ? kernels->widen : widen_one_by_one)(b->hexahedra, b->count, hints->box);
  if (hints->relative_minima) put_relative_minima(kernels, hints->leaves_valid, b, hints->relative_minima + first);
  if (!hints->coincident && !hints->accepted_by) return;
  for (int c = 0; c < b->count; ++c) {
    const double *vertices = b->hexahedra + 24 * c;
    const size_t cell = first + (size_t)c;
    const hl_verdict verdict = b->verdicts[c];
    if (hints->coincident)
      hints->coincident[cell] = verdict != HL_UNANSWERED && has_coincident_vertices(vertices, verdict == HL_VALID);
    if (hints->accepted_by)
      hints->accepted_by[cell] = verdict == HL_INVALID && may_be_accepted(vertices, b->out.corner_minima[c])
                                     ? (uint8_t)corner_checks_that_accept(vertices)
                                     : 0;
  }
}

/* Hands on and counts the answers to a block. */
static void hand_on(const lane_kernels *kernels, block *b, size_t first, hl_batch *batch, batch_stages *stages) {
  unsigned valid = 0, invalid = 0, exact = 0;
  const size_t count = (size_t)b->count;
  for (int c = 0; c < b->count; ++c) {
    valid += b->verdicts[c] == HL_VALID;
    invalid += b->verdicts[c] == HL_INVALID;
    exact += b->is_exact[c];
  }
  if (valid + invalid < count && batch->unanswered == 0)
    batch->first_unanswered = first + (size_t)((uint8_t *)memchr(b->verdicts, HL_UNANSWERED, count) - b->verdicts);
  batch->valid += valid;
  batch->invalid += invalid;
  batch->unanswered += count - valid - invalid;
  if (batch->is_exact || asks_for_minima(batch)) batch->exact += exact;
  stages->after_doubles += exact;
  memcpy(batch->verdicts + first, b->verdicts, count);
  if (batch->statuses) memcpy(batch->statuses + first, b->statuses, count);
  if (batch->is_exact) memcpy(batch->is_exact + first, b->is_exact, count);
  if (kernels && asks_for_volumes(batch)) kernels->nearest_volumes(b->hexahedra, b->count, &b->nearest);
  if (batch->classes || batch->accepted_by || asks_for_volumes(batch))
    for (int c = 0; c < b->count; ++c) put_details(kernels, batch, b, c, first + (size_t)c);
}

static bool asks_for_hints(const batch_hints *hints) {
  return hints->coincident || hints->accepted_by || hints->relative_minima || hints->box;
}

hl_status classify_with(const lane_kernels *kernels, const hl_cells *cells, hl_batch *batch, const batch_hints *hints,
                        batch_stages *stages) {
  batch_stages own = {0};
  if (!stages) stages = &own;
  *stages = own;
  const size_t length = cells->indices ? cells->index_count : cells->coordinate_count;
  const size_t per_cell = cells->indices ? HL_VERTICES : HL_COORDINATES, count = length / per_cell;
  batch->valid = batch->invalid = batch->unanswered = batch->exact = 0;
  batch->first_unanswered = count;
  if (length % per_cell != 0 || cells->coordinate_count % 3 != 0) return HL_INCOMPLETE;
  if (!batch->verdicts || ((batch->minima || batch->corner_minima) && !batch->exponents) ||
      (batch->volumes && !batch->volume_exponents))
    return HL_MISSING_LIST;
  const bool has_hints = hints && asks_for_hints(hints);
  block b;
  memset(b.copied, 0, sizeof b.copied);
  memset(b.open, 0, sizeof b.open);
  for (size_t first = 0; first < count; first += HL_BLOCK) {
    fill_block(cells, first, count - first < HL_BLOCK ? (int)(count - first) : HL_BLOCK, &b);
    choose_lists(batch, first, &b);
    if (asks_for_minima(batch)) minima_of_block(kernels, &b, stages);
    else decide_block(kernels, batch->is_exact != NULL, &b, stages);
    hand_on(kernels, &b, first, batch, stages);
    if (has_hints) put_hints(kernels, hints, first, &b);
  }
  return HL_OK;
}

hl_status hl_classify(const hl_cells *cells, hl_batch *batch) {
  return classify_with(best_lanes(), cells, batch, NULL, NULL);
}

const char *hl_vectors(void) { return best_lanes() ? best_lanes()->name : "scalar"; }
