/* Batches: blocks of cells through the fast stage, what it leaves open through the scalar code one by one, in constant
   memory (docs/algorithm.md 10). */
#include "batch.h"
#include "bernstein.h"
#include "candidates.h"
#include "face.h"
#include "filter.h"
#include "report.h"
#include "topology.h"

#include <string.h>

/* One block: its cells side by side, and what is known of them. */
typedef struct block {
  double copied[HL_BLOCK * HL_COORDINATES]; /* readable to its end, whatever is in the part that is not used */
  const double *hexahedra;
  int count;
  uint8_t verdicts[HL_BLOCK];
  double minima[HL_BLOCK], minimizers[3 * HL_BLOCK], corner_minima[HL_BLOCK];
  int16_t exponents[HL_BLOCK];
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

/* Each of the two returns how many cells have finite coordinates, up to the first that has not. */

static int decide_block(const lane_kernels *kernels, block *b, batch_stages *stages) {
  memset(b->verdicts, HL_UNDECIDED, HL_BLOCK);
  if (kernels) kernels->decide(b->hexahedra, b->count, b->verdicts);
  for (int c = 0; c < b->count; ++c) {
    if (b->verdicts[c] != HL_UNDECIDED) continue;
    hl_verdict verdict;
    if (hl_decide(b->hexahedra + 24 * c, &verdict) != HL_OK) return c;
    b->verdicts[c] = (uint8_t)verdict;
    ++stages->after_lanes;
  }
  return b->count;
}

static hl_candidate first_least_vertex(const double bernstein[27]) {
  int least = 0;
  for (int v = 1; v < HL_VERTICES; ++v)
    if (bernstein[vertex_index(v)] < bernstein[vertex_index(least)]) least = v;
  return vertex_candidate(bernstein, least);
}

/* The candidate of hl_boundary_minimum given the least vertex: passed over is only what cannot be lower, (B1) and (B2). */
static hl_candidate least_from(hl_candidate least, const double bernstein[27]) {
  for (int e = 0; e < HL_EDGES; ++e) {
    hl_candidate candidate;
    if (bernstein[vertex_index(edge_table[e].from) + axis_stride[edge_table[e].axis]] >= least.value) continue;
    if (edge_candidate(bernstein, e, &candidate) && candidate.value < least.value) least = candidate;
  }
  for (int f = 0; f < HL_FACES; ++f) {
    double beta[HL_FACE_BERNSTEIN], bound;
    face_bernstein(bernstein, f, beta);
    bound = beta[0];
    for (int i = 1; i < HL_FACE_BERNSTEIN; ++i) bound = smaller(bound, beta[i]);
    if (bound >= least.value || face_is_above(beta, least.value)) continue;
    face_solution solution;
    find_kept_roots(beta, &solution);
    for (int r = 0; r < solution.root_count; ++r)
      if (solution.values[r] < least.value) least = face_candidate(f, &solution, r);
  }
  return least;
}

static void keep_minimum(block *b, int c, const hl_candidate *least, double corner, int exponent) {
  double values[2] = {least->value, corner};
  b->exponents[c] = (int16_t)scaled_back(values, 2, exponent);
  b->minima[c] = values[0];
  b->corner_minima[c] = values[1];
  for (int axis = 0; axis < 3; ++axis) b->minimizers[3 * c + axis] = least->point[axis];
}

/* From the coordinates alone. Returns false if they are not finite. */
static bool minimum_alone(block *b, int c) {
  const double *vertices = b->hexahedra + 24 * c;
  if (!all_finite(vertices, HL_COORDINATES)) return false;
  edge_vectors edges;
  double bernstein[27];
  scaled_edge_vectors(vertices, &edges);
  jacdet_bernstein(&edges, bernstein);
  hl_candidate vertex = first_least_vertex(bernstein), least = least_from(vertex, bernstein);
  b->verdicts[c] = (uint8_t)accurate_verdict(bernstein, greatest_permanent(&edges), least.value);
  keep_minimum(b, c, &least, vertex.value, jacdet_exponent(&edges));
  return true;
}

/* From the lanes, as far as they got. */
static bool minimum_from_lanes(const lane_kernels *kernels, block *b, int c, batch_stages *stages) {
  const lane_minima *lanes = &b->lanes;
  const int state = lanes->state[c], vertex = lanes->vertex[c];
  const bool is_clear = (state & LANE_USABLE) && (state & LANE_ACCURATE) && (state & (LANE_VALID | LANE_INVALID));
  if (!is_clear) {
    ++stages->after_lanes;
    return minimum_alone(b, c);
  }
  const double corner = lanes->least[c], unit = lanes->unit[c];
  double minimum = corner;
  const unsigned char *reference = vertex_reference[vertex];
  double *minimizer = b->minimizers + 3 * c;
  for (int axis = 0; axis < 3; ++axis) minimizer[axis] = reference[axis];
  if (state & LANE_LOWER) {
    double bernstein[27];
    const double *of_group = lanes->bernstein + 27 * (c - c % kernels->width) + c % kernels->width;
    for (int i = 0; i < 27; ++i) bernstein[i] = of_group[i * kernels->width];
    hl_candidate least = least_from(vertex_candidate(bernstein, vertex), bernstein);
    minimum = least.value;
    for (int axis = 0; axis < 3; ++axis) minimizer[axis] = least.point[axis];
    ++stages->after_lanes;
  }
  if (state & LANE_VALID && !(minimum > 0)) return minimum_alone(b, c);
  b->verdicts[c] = state & LANE_INVALID ? HL_INVALID : HL_VALID;
  b->minima[c] = minimum * unit;
  b->corner_minima[c] = corner * unit;
  b->exponents[c] = 0;
  /* The rare value that is too small for the doubles goes with its exponent. */
  if (!is_normal_after_scaling(b->minima[c], 0) || !is_normal_after_scaling(b->corner_minima[c], 0))
    return minimum_alone(b, c);
  return true;
}

static int minima_of_block(const lane_kernels *kernels, block *b, batch_stages *stages) {
  if (kernels) kernels->corners(b->hexahedra, b->count, &b->lanes);
  for (int c = 0; c < b->count; ++c)
    if (!(kernels ? minimum_from_lanes(kernels, b, c, stages) : minimum_alone(b, c))) return c;
  return b->count;
}

/* Hands on and counts the first `count` cells of a block. */
static void hand_on(const block *b, size_t first, int count, hl_batch *batch, batch_stages *stages) {
  size_t counts[3] = {0};
  for (int c = 0; c < count; ++c) ++counts[b->verdicts[c]];
  batch->undecided += counts[HL_UNDECIDED];
  batch->valid += counts[HL_VALID];
  batch->invalid += counts[HL_INVALID];
  stages->after_doubles += counts[HL_UNDECIDED];
  memcpy(batch->verdicts + first, b->verdicts, (size_t)count);
  if (!batch->minima) return;
  memcpy(batch->minima + first, b->minima, (size_t)count * sizeof(double));
  memcpy(batch->minimizers + 3 * first, b->minimizers, 3 * (size_t)count * sizeof(double));
  memcpy(batch->corner_minima + first, b->corner_minima, (size_t)count * sizeof(double));
  memcpy(batch->exponents + first, b->exponents, (size_t)count * sizeof(int16_t));
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
  for (size_t first = 0; first < count; first += HL_BLOCK) {
    const int wanted = count - first < HL_BLOCK ? (int)(count - first) : HL_BLOCK;
    b.count = fill_block(cells, first, wanted, &b);
    const int with_points = b.count;
    const int finite =
        batch->minima ? minima_of_block(kernels, &b, stages) : decide_block(kernels, &b, stages);
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
