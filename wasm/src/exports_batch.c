/* What WebAssembly exports for batches. Lists lie in memory that the caller has grown for them; counts in a static one. */
#include "hexlens.h"

#define EXPORT(name) __attribute__((export_name(#name)))

/* Undecided cells, then the first that is at fault. */
static uint32_t counts[2];

EXPORT(counts_address) uint32_t *counts_address(void) { return counts; }

/* Returns an hl_status. `minima` and the three lists that belong to it are null (0) where only verdicts are wanted, `indices` for
   cells of 24 coordinates each. */
EXPORT(classify)
int classify(const double *coordinates, size_t coordinate_count, const uint32_t *indices, size_t index_count,
             uint8_t *verdicts, double *minima, double *minimizers, double *corner_minima, int16_t *exponents) {
  hl_cells cells = {coordinates, coordinate_count, indices, index_count};
  hl_batch batch = {verdicts, minima, minimizers, corner_minima, exponents, 0, 0, 0, 0};
  hl_status status = hl_classify(&cells, &batch);
  counts[0] = (uint32_t)batch.undecided;
  counts[1] = (uint32_t)batch.first_bad_cell;
  return (int)status;
}

/* For benchmarks: of elements whose jacdets are doubles as they are. */
EXPORT(tangent_bound) double tangent_bound_of(const double *vertices, int tangents) {
  hl_bound bound = {0, 0};
  hl_tangent_bound(vertices, tangents, &bound);
  return bound.value;
}
