/* The exports of WebAssembly for batches. The caller grows the memory for lists. */
#include "batch.h"

#define EXPORT(name) __attribute__((export_name(#name)))

/* The addresses of the lists of hl_batch and batch_hints in their order, 0 for what is not asked for; then what is counted, in the order
   there. */
enum { LISTS = 15, COUNTS = 5 };
static uint32_t lists[LISTS], counts[COUNTS];

EXPORT(lists_address) uint32_t *lists_address(void) { return lists; }

EXPORT(counts_address) uint32_t *counts_address(void) { return counts; }

/* Returns an hl_status; `indices` are null (0) for cells of 24 coordinates each. */
EXPORT(classify)
int classify(const double *coordinates, size_t coordinate_count, const uint32_t *indices, size_t index_count) {
  hl_cells cells = {coordinates, coordinate_count, indices, index_count};
  void *at[LISTS];
  for (int i = 0; i < LISTS; ++i) at[i] = (void *)(uintptr_t)lists[i];
  hl_batch batch = {at[0], at[1],  at[2],  at[3], at[4], at[5], at[6], at[7], at[8],
                    at[9], at[10], at[11], 0,     0,     0,     0,     0};
  const batch_hints hints = {at[12], at[13], at[14]};
  const hl_status status = classify_with(best_lanes(), &cells, &batch, &hints, NULL);
  const size_t found[COUNTS] = {batch.valid, batch.invalid, batch.unanswered, batch.exact, batch.first_unanswered};
  for (int i = 0; i < COUNTS; ++i) counts[i] = (uint32_t)found[i];
  return (int)status;
}

/* The tangent bound for benchmarks: of elements whose jacdets are doubles as they are. */
EXPORT(tangent_bound) double tangent_bound_of(const double *vertices, int tangents) {
  hl_bound bound = {0, 0};
  hl_tangent_bound(vertices, tangents, &bound);
  return bound.value;
}
