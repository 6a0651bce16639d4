/* The exports of WebAssembly for batches. The caller grows the memory for lists. */
#include "batch.h"

#define EXPORT(name) __attribute__((export_name(#name)))

/* The addresses of the lists of hl_batch and batch_hints in their order, 0 for what is not asked for; then what is counted, in the order
   there, and in these lists. */
enum { LISTS = 14, COUNTS = 10 };
static uint32_t lists[LISTS], counts[COUNTS];
static double box[6];

/* Cells that may be given at once where candidates are asked for; CELLS_PER_CUT of batch-core.ts. */
enum { AT_ONCE = 1024 };
static uint32_t candidates[AT_ONCE];
static float about[AT_ONCE];

EXPORT(lists_address) uint32_t *lists_address(void) { return lists; }

EXPORT(counts_address) uint32_t *counts_address(void) { return counts; }

/* Least x, y and z, then the greatest, which every call widens: the caller empties it. */
EXPORT(box_address) double *box_address(void) { return box; }

EXPORT(candidates_address) uint32_t *candidates_address(void) { return candidates; }

/* Relative minima of all cells of the last call that was asked for candidates, within 2^-20; NaN where that is not certain. */
EXPORT(about_address) float *about_address(void) { return about; }

/* Indices of points from `first` on become places among these. */
EXPORT(take_from) void take_from(uint32_t *indices, size_t count, uint32_t first) {
  for (size_t i = 0; i < count; ++i) indices[i] -= first;
}

__attribute__((noinline)) static uint32_t count_of(const uint8_t *list, size_t count, uint8_t bits, uint8_t value) {
  uint32_t found = 0;
  for (size_t i = 0; list && i < count; ++i) found += (list[i] & bits) == value;
  return found;
}

/* Cells whose relative minima may be at most `limit`. A valid cell's is not below 0. */
static uint32_t find_candidates(const uint8_t *verdicts, size_t count, double limit) {
  uint32_t found = 0;
  for (size_t i = 0; i < count; ++i) {
    if (about[i] > limit || verdicts[i] == HL_UNANSWERED) continue;
    if (verdicts[i] == HL_VALID && limit <= 0) continue;
    candidates[found++] = (uint32_t)i;
  }
  return found;
}

/* Returns an hl_status; `indices` are null (0) for cells of 24 coordinates each. `has_box` widens the box; with minima, `has_candidates` finds
   the candidates for a limit of relative minima. */
EXPORT(classify)
int classify(const double *coordinates, size_t coordinate_count, const uint32_t *indices, size_t index_count,
             int has_box, int has_candidates, double limit) {
  hl_cells cells = {coordinates, coordinate_count, indices, index_count};
  void *at[LISTS];
  for (int i = 0; i < LISTS; ++i) at[i] = (void *)(uintptr_t)lists[i];
  hl_batch batch = {at[0], at[1],  at[2],  at[3], at[4], at[5], at[6], at[7], at[8],
                    at[9], at[10], at[11], 0,     0,     0,     0,     0};
  const batch_hints hints = {at[12], at[13], has_candidates ? about : 0, limit <= 0, has_box ? box : 0};
  const hl_status status = classify_with(best_lanes(), &cells, &batch, &hints, NULL);
  if (status != HL_OK) return (int)status;
  const size_t count = indices ? index_count / HL_VERTICES : coordinate_count / HL_COORDINATES;
  const uint8_t corners = 1 << HL_CHECK_CORNERS, vtk = 1 << HL_CHECK_CORNERS_AND_CENTRE;
  const uint32_t found[COUNTS] = {(uint32_t)batch.valid,
                                  (uint32_t)batch.invalid,
                                  (uint32_t)batch.unanswered,
                                  (uint32_t)batch.exact,
                                  (uint32_t)batch.first_unanswered,
                                  count_of(batch.classes, count, 0xff, HL_CLASS_INVERTED),
                                  count_of(hints.coincident, count, 0xff, 1),
                                  count_of(hints.accepted_by, count, corners, corners),
                                  count_of(hints.accepted_by, count, vtk, vtk),
                                  has_candidates ? find_candidates(batch.verdicts, count, limit) : 0};
  for (int i = 0; i < COUNTS; ++i) counts[i] = found[i];
  /* 1 for a valid cell, 0 for any other. */
  for (size_t i = 0; i < count; ++i) batch.verdicts[i] &= HL_VALID;
  return (int)status;
}

/* The tangent bound for benchmarks: of elements whose jacdets are doubles as they are. */
EXPORT(tangent_bound) double tangent_bound_of(const double *vertices, int tangents) {
  hl_bound bound = {0, 0};
  hl_tangent_bound(vertices, tangents, &bound);
  return bound.value;
}
