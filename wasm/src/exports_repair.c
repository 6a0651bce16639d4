/* The exports of hexlens-repair.wasm. The caller grows the memory for the star and for the search. */
#include "hexlens.h"

#define EXPORT(name) __attribute__((export_name(#name)))

static double output[HL_PACKED_PLACE];

EXPORT(output_address) double *output_address(void) { return output; }

EXPORT(output_length) int output_length(void) { return HL_PACKED_PLACE; }

EXPORT(best_place_room) size_t best_place_room(size_t cell_count) { return hl_best_place_room(cell_count); }

/* Returns an hl_status; `indices` are null (0) for cells of 24 coordinates each, `moving` for the vertex of that index. */
EXPORT(best_place)
int best_place(const double *coordinates, size_t coordinate_count, const uint32_t *indices, size_t index_count,
               const uint8_t *moving, uint32_t vertex, void *memory, size_t room) {
  const hl_star star = {{coordinates, coordinate_count, indices, index_count}, moving, vertex};
  hl_place place;
  const hl_status status = hl_best_place(&star, memory, room, &place);
  if (status == HL_OK) hl_pack_place(&place, output);
  return (int)status;
}
