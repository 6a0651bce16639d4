/* The exports of hexlens-repair.wasm. The caller grows the memory for the star and for the search. */
#include "untangle.h"

#define EXPORT(name) __attribute__((export_name(#name)))

static double output[HL_PACKED_PLACE];
static untangling *under_way;

EXPORT(output_address) double *output_address(void) { return output; }

EXPORT(output_length) int output_length(void) { return HL_PACKED_PLACE; }

EXPORT(best_place_room) size_t best_place_room(size_t cell_count) { return hl_best_place_room(cell_count); }

/* Returns an hl_status; `indices` are null (0) for cells of 24 coordinates each, `moving` for the vertex of that index, `limits` if there
   are none. */
EXPORT(best_place)
int best_place(const double *coordinates, size_t coordinate_count, const uint32_t *indices, size_t index_count,
               const uint8_t *moving, uint32_t vertex, const hl_limits *limits, void *memory, size_t room) {
  const hl_star star = {{coordinates, coordinate_count, indices, index_count}, moving, vertex, limits};
  hl_place place;
  const hl_status status = hl_best_place(&star, memory, room, &place);
  if (status == HL_OK) hl_pack_place(&place, output);
  return (int)status;
}

EXPORT(untangle_room) size_t untangle_room(size_t point_count, size_t cell_count) {
  return hl_untangle_room(point_count, cell_count, 1);
}

/* Returns an hl_status. */
EXPORT(reversed_cells)
int reversed_cells(const double *coordinates, size_t coordinate_count, const uint32_t *indices, size_t index_count,
                   void *memory, size_t room, uint8_t *reversed) {
  const hl_cells cells = {coordinates, coordinate_count, indices, index_count};
  return (int)hl_reversed_cells(&cells, memory, room, reversed);
}

/* Returns an hl_status. All lists stay where they are until the untangling has ended; one at a time. */
EXPORT(begin_untangle)
int begin_untangle(const double *coordinates, size_t coordinate_count, const uint32_t *indices, size_t index_count,
                   const uint8_t *moves, double margin, int slides, double boundary_distance, void *memory, size_t room,
                   double *points) {
  const hl_cells cells = {coordinates, coordinate_count, indices, index_count};
  const hl_untangling wanted = {.margin = margin,
                                .moves = moves,
                                .slides = slides != 0,
                                .boundary_distance = boundary_distance,
                                .thread_count = 1};
  return (int)begin_untangling(&cells, &wanted, memory, room, points, &under_way);
}

/* Leaves what was done so far in the output; 0 when there is nothing more to do. */
EXPORT(step_untangle) int step_untangle(void) {
  const bool is_going_on = step_untangling(under_way);
  hl_pack_untangled(result_so_far(under_way), output);
  return is_going_on;
}

EXPORT(end_untangle) void end_untangle(uint8_t *held) {
  hl_untangled result;
  end_untangling(under_way, held, &result);
  hl_pack_untangled(&result, output);
}

/* The limits of a point in the order of hl_limits, while nothing has changed since end_untangle. */
EXPORT(untangled_limits) double *untangled_limits(uint32_t point) {
  static hl_limits limits;
  hl_untangled_limits(under_way, point, &limits);
  return (double *)&limits;
}
