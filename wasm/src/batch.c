/* Batches: blocks of cells through the fast stage, what it leaves open through the scalar code one by one, in constant
   memory (docs/algorithm.md 10). */
#include "batch.h"
#include "bernstein.h"
#include "candidates.h"
#include "face.h"
#include "filter.h"
#include "report.h"
#include "topology.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* One block: its cells side by side, and what is known of them. */
typedef struct block {
  double copied[HL_BLOCK * HL_COORDINATES]; /* readable to its end, whatever is in the part that is not used */
  const double *hexahedra;
  int count;
  uint8_t verdicts[HL_BLOCK];
  double undecided[HL_BLOCK * HL_COORDINATES];
  lane_minima lanes;
} block;

/* Copies the cells' points next to each other; returns how many cells have all their indices. */
static int gather(const hl_cells *cells, size_t first, int count, double *hexahedra) {
  const size_t point_count = cells->coordinate_count / 3;
  for (int c = 0; c < count; ++c) {
    const uint32_t *indices = cells->indices + 8 * (first + (size_t)c);
    for (int v = 0; v < 8; ++v)
      if (indices[v] >= point_count) return c;
    for (int v = 0; v < 8; ++v)
      memcpy(hexahedra + 24 * c + 3 * v, cells->coordinates + 3 * (size_t)indices[v], 3 * sizeof(double));
  }
  return count;
}

/* A whole block of plain coordinates is read where it is. */
static int fill_block(const hl_cells *cells, size_t first, int count, block *b) {
  b->count = count;
  if (!cells->indices && count == HL_BLOCK) {
    b->hexahedra = cells->coordinates + 24 * first;
    return count;
  }
  b->hexahedra = b->copied;
  if (cells->indices) return gather(cells, first, count, b->copied);
  memcpy(b->copied, cells->coordinates + 24 * first, (size_t)count * HL_COORDINATES * sizeof(double));
  return count;
}

/* The coefficients that the lanes have computed. */
static void bernstein_from_lanes(const lane_kernels *kernels, const lane_minima *lanes, int c, double bernstein[27]) {
  const int width = kernels->width, lane = c & (width - 1);
  const double *of_group = lanes->bernstein + 27 * (c - lane) + lane;
  for (int i = 0; i < HL_BERNSTEIN; ++i) bernstein[i] = bernstein_part[i] * of_group[i * width] + 0.0;
}

/* hl_decide, from what the lanes know in doubles. Returns false if the coordinates are not finite. */
static bool decide_cell(const lane_kernels *kernels, const lane_minima *lanes, int c, const double *vertices,
                        uint8_t *verdict) {
  hl_verdict found = HL_INVALID;
  if (!kernels || !(lanes->state[c] & LANE_USABLE)) {
    if (hl_decide(vertices, &found) != HL_OK) return false;
  } else if (lanes->state[c] & LANE_VALID) {
    found = HL_VALID;
  } else if (!(lanes->state[c] & LANE_INVALID)) {
    double bernstein[27];
    bernstein_from_lanes(kernels, lanes, c, bernstein);
    found = filtered_verdict(bernstein);
  }
  *verdict = (uint8_t)found;
  return true;
}

/* Each of the two below returns how many cells have finite coordinates, up to the first that has not. */

/* Whether one of eight bytes is 0. */
static bool has_undecided(const uint8_t *verdicts) {
  uint64_t bytes;
  memcpy(&bytes, verdicts, sizeof bytes);
  return ((bytes - 0x0101010101010101u) & ~bytes & 0x8080808080808080u) != 0;
}

/* In floats, then those that are open together in doubles, then one by one. */
static int decide_block(const lane_kernels *kernels, block *b, batch_stages *stages) {
  int open[HL_BLOCK], open_count = 0;
  memset(b->verdicts, HL_UNDECIDED, HL_BLOCK);
  if (kernels) kernels->decide(b->hexahedra, b->count, b->verdicts);
  for (int c = 0; c < b->count; c += 8) {
    if (!has_undecided(b->verdicts + c)) continue;
    for (int d = c; d < c + 8 && d < b->count; ++d)
      if (b->verdicts[d] == HL_UNDECIDED) open[open_count++] = d;
  }
  stages->after_lanes += (size_t)open_count;
  if (kernels && open_count > 0) {
    for (int i = 0; i < open_count; ++i)
      memcpy(b->undecided + 24 * i, b->hexahedra + 24 * open[i], HL_COORDINATES * sizeof(double));
    kernels->corners(b->undecided, open_count, &b->lanes);
  }
  for (int i = 0; i < open_count; ++i)
    if (!decide_cell(kernels, &b->lanes, i, b->hexahedra + 24 * open[i], b->verdicts + open[i])) return open[i];
  return b->count;
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

/* Those of the faces that have one of these bits. */
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

static void put_minimizer(hl_batch *batch, size_t cell, const double point[3]) {
  for (int axis = 0; axis < 3; ++axis) batch->minimizers[3 * cell + (size_t)axis] = point[axis];
}

/* From the coordinates alone. Returns false if they are not finite. */
static bool minimum_alone(const double *vertices, uint8_t *verdict, hl_batch *batch, size_t cell) {
  if (!all_finite(vertices, HL_COORDINATES)) return false;
  edge_vectors edges;
  double bernstein[27];
  scaled_edge_vectors(vertices, &edges);
  jacdet_bernstein(&edges, bernstein);
  hl_candidate vertex = first_least_vertex(bernstein), least = least_from(vertex, bernstein);
  *verdict = (uint8_t)accurate_verdict(bernstein, greatest_permanent(&edges), least.value);
  double values[2] = {least.value, vertex.value};
  batch->exponents[cell] = (int16_t)scaled_back(values, 2, jacdet_exponent(&edges));
  batch->minima[cell] = values[0];
  batch->corner_minima[cell] = values[1];
  put_minimizer(batch, cell, least.point);
  return true;
}

/* Whether a value that is `scaled` times a power of two has come out whole: not lost below the normal doubles. */
static bool is_whole(double value, double scaled) { return scaled == 0 || fabs(value) >= DBL_MIN; }

/* The least corner stands there as the minimum, with its verdict: lowers it to the boundary minimum, by the coefficients that the
   lanes have computed, which are accurate. Returns false where a value is too small for the doubles. */
static bool lower_minimum(const lane_kernels *kernels, const lane_minima *lanes, int c, uint8_t *verdict,
                          hl_batch *batch, size_t cell) {
  double bernstein[27];
  bernstein_from_lanes(kernels, lanes, c, bernstein);
  hl_candidate least = least_from(vertex_candidate(bernstein, lanes->vertex[c]), bernstein);
  if (!(lanes->state[c] & (LANE_VALID | LANE_INVALID))) *verdict = (uint8_t)filtered_verdict(bernstein);
  if (*verdict == HL_VALID && !(least.value > 0)) *verdict = HL_UNDECIDED;
  batch->minima[cell] = least.value * lanes->unit[c];
  put_minimizer(batch, cell, least.point);
  return is_whole(batch->minima[cell], least.value) &&
         is_whole(batch->corner_minima[cell], bernstein[vertex_index(lanes->vertex[c])]);
}

/* The least corners of the block's cells `from` to `to`, as if all were settled. */
static void put_corners(block *b, int from, int to, size_t first, hl_batch *batch) {
  const lane_minima *lanes = &b->lanes;
  const size_t cell = first + (size_t)from, count = (size_t)(to - from);
  memcpy(batch->minima + cell, lanes->least + from, count * sizeof(double));
  memcpy(batch->corner_minima + cell, lanes->least + from, count * sizeof(double));
  memset(batch->exponents + cell, 0, count * sizeof(int16_t));
  for (int c = from; c < to; ++c) b->verdicts[c] = lanes->state[c] & LANE_VALID ? HL_VALID : HL_INVALID;
  for (int c = from; c < to; ++c)
    memcpy(batch->minimizers + 3 * (first + (size_t)c), vertex_point[lanes->vertex[c]], sizeof vertex_point[0]);
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

/* In doubles side by side, then one by one. Nothing is written of cells behind one that is not finite. */
static int minima_of_block(const lane_kernels *kernels, block *b, size_t first, hl_batch *batch, batch_stages *stages) {
  const lane_minima *lanes = &b->lanes;
  if (kernels) kernels->corners(b->hexahedra, b->count, &b->lanes);
  for (int from = 0, to; from < b->count; from = to + 1) {
    to = kernels ? first_without(lanes->state, LANE_USABLE, from, b->count) : from;
    put_corners(b, from, to, first, batch);
    for (int c = from; (c = first_without(lanes->state, LANE_SETTLED, c, to)) < b->count && c <= to; ++c) {
      const size_t cell = first + (size_t)c;
      ++stages->after_lanes;
      if (c < to && lanes->state[c] & LANE_ACCURATE && lower_minimum(kernels, lanes, c, b->verdicts + c, batch, cell))
        continue;
      if (!minimum_alone(b->hexahedra + 24 * c, b->verdicts + c, batch, cell)) return c;
    }
  }
  return b->count;
}

/* Hands on and counts the first `count` verdicts of a block. */
static void hand_on(const block *b, size_t first, int count, hl_batch *batch, batch_stages *stages) {
  unsigned valid = 0, invalid = 0;
  for (int c = 0; c < count; ++c) {
    valid += b->verdicts[c] == HL_VALID;
    invalid += b->verdicts[c] == HL_INVALID;
  }
  batch->valid += valid;
  batch->invalid += invalid;
  batch->undecided += (size_t)count - valid - invalid;
  stages->after_doubles = batch->undecided;
  memcpy(batch->verdicts + first, b->verdicts, (size_t)count);
}

hl_status classify_with(const lane_kernels *kernels, const hl_cells *cells, hl_batch *batch, batch_stages *stages) {
  batch_stages own = {0};
  if (!stages) stages = &own;
  *stages = own;
  const size_t length = cells->indices ? cells->index_count : cells->coordinate_count;
  const size_t per_cell = cells->indices ? HL_VERTICES : HL_COORDINATES, count = length / per_cell;
  batch->valid = batch->invalid = batch->undecided = 0;
  batch->first_bad_cell = count;
  if (length % per_cell != 0 || cells->coordinate_count % 3 != 0) return HL_INCOMPLETE;
  block b;
  memset(b.copied, 0, sizeof b.copied);
  memset(b.undecided, 0, sizeof b.undecided);
  for (size_t first = 0; first < count; first += HL_BLOCK) {
    const int wanted = count - first < HL_BLOCK ? (int)(count - first) : HL_BLOCK;
    b.count = fill_block(cells, first, wanted, &b);
    const int with_points = b.count;
    const int finite =
        batch->minima ? minima_of_block(kernels, &b, first, batch, stages) : decide_block(kernels, &b, stages);
    hand_on(&b, first, finite, batch, stages);
    if (finite == wanted) continue;
    batch->first_bad_cell = first + (size_t)finite;
    return finite < with_points ? HL_NOT_FINITE : HL_NO_SUCH_POINT;
  }
  return HL_OK;
}

hl_status hl_classify(const hl_cells *cells, hl_batch *batch) {
  return classify_with(best_lanes(), cells, batch, NULL);
}

const char *hl_vectors(void) { return best_lanes() ? best_lanes()->name : "scalar"; }
