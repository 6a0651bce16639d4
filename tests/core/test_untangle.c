/* Sweeps of best places: all of a noisy grid repaired, the boundary where it was, no cell's neighbourhood lowered, the same again; stops. */
#include "check.h"
#include "hexlens.h"
#include "random.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE = 9, EDGE = SIDE + 1, POINTS = EDGE * EDGE * EDGE, CELLS = SIDE * SIDE * SIDE };

static random_stream stream = {20260701};
static double given[3 * POINTS], moved[3 * POINTS];
static uint32_t indices[8 * CELLS];

static bool is_inside(int p) {
  const int at[3] = {p % EDGE, p / EDGE % EDGE, p / EDGE / EDGE};
  bool inside = true;
  for (int r = 0; r < 3; ++r) inside = inside && at[r] > 0 && at[r] < SIDE;
  return inside;
}

static hl_cells noisy_grid(double sigma) {
  static const int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (int p = 0; p < POINTS; ++p)
    for (int r = 0; r < 3; ++r) {
      const int at = r == 0 ? p % EDGE : r == 1 ? p / EDGE % EDGE : p / EDGE / EDGE;
      given[3 * p + r] = at + (is_inside(p) ? sigma * random_normal(&stream) : 0);
    }
  for (int c = 0; c < CELLS; ++c)
    for (int v = 0; v < 8; ++v) {
      const int *o = corner[v];
      indices[8 * c + v] =
          (uint32_t)(c % SIDE + o[0] + EDGE * (c / SIDE % SIDE + o[1] + EDGE * (c / SIDE / SIDE + o[2])));
    }
  return (hl_cells){given, 3 * POINTS, indices, 8 * CELLS};
}

static hl_untangled untangled(const hl_cells *cells, const hl_untangling *wanted) {
  const size_t room = hl_untangle_room(POINTS, CELLS, 1);
  void *memory = malloc(room);
  hl_untangled result;
  CHECK(hl_untangle(cells, wanted, memory, room, moved, &result) == HL_OK, "status");
  free(memory);
  return result;
}

static size_t invalid_count(const double *points) {
  static uint8_t verdicts[CELLS];
  const hl_cells cells = {points, 3 * POINTS, indices, 8 * CELLS};
  hl_batch batch = {.verdicts = verdicts};
  hl_classify(&cells, &batch);
  return batch.invalid;
}

static void finds_the_boundary(void) {
  static uint8_t boundary[POINTS];
  const hl_cells cells = noisy_grid(0);
  const size_t room = hl_untangle_room(POINTS, CELLS, 1);
  void *memory = malloc(room);
  CHECK(hl_boundary_points(&cells, memory, room, boundary) == HL_OK, "status");
  for (int p = 0; p < POINTS; ++p) CHECK(boundary[p] == !is_inside(p), "%d", p);
  free(memory);
}

static void repairs_noise_and_keeps_the_boundary(void) {
  size_t repaired = 0;
  for (int n = 0; n < TIMES(16); ++n) {
    const hl_cells cells = noisy_grid(0.14 + 0.01 * (n % 4));
    const hl_untangling wanted = {.margin = n % 2 ? 0.1 : 0};
    const hl_untangled result = untangled(&cells, &wanted);
    CHECK(result.invalid_before == invalid_count(given), "%d: %zu invalid before", n, result.invalid_before);
    CHECK(result.invalid_after == 0 && invalid_count(moved) == 0, "%d: %zu invalid after", n, result.invalid_after);
    CHECK(result.below_after == 0, "%d: %zu below the margin", n, result.below_after);
    CHECK(result.least_after >= wanted.margin, "%d: least %.17g", n, result.least_after);
    size_t moves = 0;
    for (int p = 0; p < POINTS; ++p) {
      const bool is_moved = memcmp(given + 3 * p, moved + 3 * p, 3 * sizeof(double)) != 0;
      CHECK(!is_moved || is_inside(p), "%d: boundary point %d", n, p);
      moves += is_moved;
    }
    CHECK(moves == result.moved_count, "%d: %zu moves, %zu said", n, moves, result.moved_count);
    repaired += result.invalid_before;
  }
  CHECK(repaired > TIMES(16), "%zu cells", repaired);
}

/* Hard ones: not all are repaired, and the worst does not become worse. */
static void never_lowers_the_worst(void) {
  for (int n = 0; n < TIMES(4); ++n) {
    const hl_cells cells = noisy_grid(0.25 + 0.05 * n);
    const hl_untangling wanted = {.margin = 0};
    const hl_untangled result = untangled(&cells, &wanted);
    CHECK(result.least_after >= result.least_before, "%d: %.17g to %.17g", n, result.least_before, result.least_after);
    CHECK(result.invalid_after == invalid_count(moved), "%d: %zu said to be invalid", n, result.invalid_after);
  }
}

static void is_the_same_again(void) {
  static double first[3 * POINTS];
  const hl_cells cells = noisy_grid(0.16);
  const hl_untangling wanted = {.margin = 0.1};
  untangled(&cells, &wanted);
  memcpy(first, moved, sizeof first);
  untangled(&cells, &wanted);
  CHECK(memcmp(first, moved, sizeof first) == 0, "other bits");
}

static bool goes_on(void *context, const hl_untangled *so_far) {
  *(size_t *)context = so_far->place_count;
  return so_far->place_count < 3;
}

static void leaves_what_is_fixed_and_stops(void) {
  static uint8_t moves[POINTS];
  memset(moves, HL_STAYS, sizeof moves);
  const hl_cells cells = noisy_grid(0.2);
  hl_untangling wanted = {.margin = 0.1, .moves = moves};
  hl_untangled result = untangled(&cells, &wanted);
  CHECK(result.moved_count == 0 && memcmp(given, moved, sizeof given) == 0, "fixed points moved");
  size_t seen = 0;
  wanted = (hl_untangling){.margin = 0.1, .proceed = goes_on, .context = &seen};
  result = untangled(&cells, &wanted);
  CHECK(result.is_stopped && result.place_count >= 3 && seen == result.place_count, "%zu places", result.place_count);
}

static void refuses_what_is_no_mesh(void) {
  hl_cells cells = noisy_grid(0.1);
  const hl_untangling wanted = {.margin = 0};
  hl_untangled result;
  double memory[4];
  CHECK(hl_untangle(&cells, &wanted, memory, sizeof memory, moved, &result) == HL_NO_ROOM, "room");
  cells.indices = NULL;
  CHECK(hl_untangle(&cells, &wanted, memory, sizeof memory, moved, &result) == HL_MISSING_LIST, "no indices");
  cells = noisy_grid(0.1);
  cells.index_count = 9;
  CHECK(hl_untangle(&cells, &wanted, memory, sizeof memory, moved, &result) == HL_INCOMPLETE, "nine indices");
}

int main(void) {
  RUN(finds_the_boundary);
  RUN(repairs_noise_and_keeps_the_boundary);
  RUN(never_lowers_the_worst);
  RUN(is_the_same_again);
  RUN(leaves_what_is_fixed_and_stops);
  RUN(refuses_what_is_no_mesh);
  return test_summary();
}
