/* Sweeps of best places: all of a noisy grid repaired, the boundary where it was, in its planes or near, nothing that is touched lowered,
   the same bits again and with several threads; stops. Cells that are numbered the other way round. */
#include "check.h"
#include "hexlens.h"
#include "random.h"

#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

/* Meshes: each takes long, and under the sanitizers fewer would leave nothing to repair. */
enum { MESHES = SHARE == 1 ? 16 : 4, HARD_MESHES = MESHES / 4 };

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

/* The axes along which a point is on the boundary. */
static bool is_at_end(int p, int r) {
  const int at = r == 0 ? p % EDGE : r == 1 ? p / EDGE % EDGE : p / EDGE / EDGE;
  return at == 0 || at == SIDE;
}

/* Boundary points have noise in their planes and along their edges only, where it is asked for. */
static hl_cells grid_with_noise(double sigma, double boundary_sigma) {
  static const int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (int p = 0; p < POINTS; ++p)
    for (int r = 0; r < 3; ++r) {
      const int at = r == 0 ? p % EDGE : r == 1 ? p / EDGE % EDGE : p / EDGE / EDGE;
      const double noise = is_inside(p) ? sigma : is_at_end(p, r) ? 0 : boundary_sigma;
      given[3 * p + r] = at + (noise > 0 ? noise * random_normal(&stream) : 0);
    }
  for (int c = 0; c < CELLS; ++c)
    for (int v = 0; v < 8; ++v) {
      const int *o = corner[v];
      indices[8 * c + v] =
          (uint32_t)(c % SIDE + o[0] + EDGE * (c / SIDE % SIDE + o[1] + EDGE * (c / SIDE / SIDE + o[2])));
    }
  return (hl_cells){given, 3 * POINTS, indices, 8 * CELLS};
}

static hl_cells noisy_grid(double sigma) { return grid_with_noise(sigma, 0); }

static hl_untangled untangled(const hl_cells *cells, const hl_untangling *wanted) {
  const size_t room = hl_untangle_room(POINTS, CELLS, wanted->thread_count);
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
  for (int n = 0; n < MESHES; ++n) {
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
  CHECK(repaired > MESHES, "%zu cells", repaired);
}

/* The least relative minimum of the cells that have a moved point. */
static double least_of_touched(const double *points) {
  static uint8_t verdicts[CELLS];
  static double values[CELLS];
  const hl_cells cells = {points, 3 * POINTS, indices, 8 * CELLS};
  hl_batch batch = {.verdicts = verdicts, .relative_minima = values};
  hl_classify(&cells, &batch);
  double least = INFINITY;
  for (int c = 0; c < CELLS; ++c) {
    bool is_touched = false;
    for (int v = 0; v < 8; ++v) {
      const size_t p = 3 * indices[8 * c + v];
      is_touched = is_touched || memcmp(given + p, moved + p, 3 * sizeof(double)) != 0;
    }
    if (is_touched) least = fmin(least, values[c] == values[c] ? values[c] : -INFINITY);
  }
  return least;
}

/* Hard ones: not all are repaired, and the worst does not become worse. */
static void never_lowers_the_worst(void) {
  for (int n = 0; n < HARD_MESHES; ++n) {
    const hl_cells cells = noisy_grid(0.15 + 0.05 * n);
    const hl_untangling wanted = {.margin = n % 2 ? 0.2 : 0};
    const hl_untangled result = untangled(&cells, &wanted);
    CHECK(result.least_after >= result.least_before, "%d: %.17g to %.17g", n, result.least_before, result.least_after);
    CHECK(result.invalid_after == invalid_count(moved), "%d: %zu said to be invalid", n, result.invalid_after);
    const double before = least_of_touched(given), after = least_of_touched(moved);
    CHECK(after >= before && before < INFINITY, "%d: what is touched, %.17g to %.17g", n, before, after);
  }
}

/* Turns a point about the axis (1, 1, 0). */
static void turn(double angle, double *p) {
  const double c = cos(angle), s = sin(angle), k = sqrt(0.5), along = k * (p[0] + p[1]);
  const double axis[3] = {k, k, 0}, across[3] = {k * p[2], -k * p[2], k * (p[1] - p[0])};
  for (int r = 0; r < 3; ++r) p[r] = c * p[r] + s * across[r] + (1 - c) * along * axis[r];
}

static void slides_in_planes(void) {
  for (int is_turned = 0; is_turned < 2; ++is_turned) {
    const hl_cells cells = grid_with_noise(0.1, 0.35);
    for (int p = 0; p < POINTS && is_turned; ++p) turn(0.3, given + 3 * p);
    hl_untangling wanted = {.margin = 0.2};
    const hl_untangled fixed = untangled(&cells, &wanted);
    wanted.slides = true;
    const hl_untangled result = untangled(&cells, &wanted);
    CHECK(fixed.invalid_after > 0 && result.invalid_after < fixed.invalid_after / 4, "%zu, slid %zu",
          fixed.invalid_after, result.invalid_after);
    size_t slid = 0;
    for (int p = 0; p < POINTS; ++p) {
      double before[3], after[3];
      memcpy(before, given + 3 * p, sizeof before);
      memcpy(after, moved + 3 * p, sizeof after);
      slid += !is_inside(p) && memcmp(before, after, sizeof before) != 0;
      if (is_turned) turn(-0.3, before);
      if (is_turned) turn(-0.3, after);
      for (int r = 0; r < 3; ++r)
        if (is_at_end(p, r))
          CHECK(fabs(after[r] - before[r]) <= (is_turned ? 1e-12 : 0), "%d, axis %d: %g", p, r, after[r] - before[r]);
    }
    CHECK(slid > 20, "%zu", slid);
  }
}

static void keeps_the_distance(void) {
  static uint8_t held[POINTS];
  const double distance = 0.125;
  const hl_cells cells = grid_with_noise(0.1, 0.35);
  const hl_untangling wanted = {.margin = 0.2, .boundary_distance = distance, .held = held};
  const hl_untangled result = untangled(&cells, &wanted);
  double greatest = 0;
  for (int p = 0; p < POINTS; ++p) {
    const double way[3] = {moved[3 * p] - given[3 * p], moved[3 * p + 1] - given[3 * p + 1],
                           moved[3 * p + 2] - given[3 * p + 2]};
    const double length = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    CHECK(is_inside(p) || length <= distance, "%d: %.17g", p, length);
    if (!is_inside(p)) greatest = fmax(greatest, length);
  }
  CHECK(greatest > 0.99 * distance, "%g", greatest);
  size_t held_count = 0;
  for (int p = 0; p < POINTS; ++p) held_count += held[p];
  CHECK((held_count > 0) == (result.below_after > 0), "%zu held, %zu below", held_count, result.below_after);
}

typedef struct share {
  void (*work)(void *piece, size_t thread);
  void *piece;
  size_t thread;
} share;

static void *do_share(void *given_share) {
  const share *s = given_share;
  s->work(s->piece, s->thread);
  return NULL;
}

static void run_in_threads(void *context, void (*work)(void *piece, size_t thread), void *piece, size_t count) {
  pthread_t threads[3];
  share shares[3];
  ++*(size_t *)context;
  for (size_t i = 0; i < count; ++i) {
    shares[i] = (share){work, piece, i};
    CHECK(pthread_create(&threads[i], NULL, do_share, &shares[i]) == 0, "thread %zu", i);
  }
  for (size_t i = 0; i < count; ++i) pthread_join(threads[i], NULL);
}

static void threads_do_not_matter(void) {
  static double first[3 * POINTS];
  for (int n = 0; n < 3; ++n) {
    const hl_cells cells = grid_with_noise(0.15 + 0.05 * n, 0.1);
    size_t pieces = 0;
    hl_untangling wanted = {.margin = 0.15, .slides = n == 1, .context = &pieces};
    const hl_untangled one = untangled(&cells, &wanted);
    memcpy(first, moved, sizeof first);
    wanted.run = run_in_threads;
    for (wanted.thread_count = 1; wanted.thread_count <= 3; ++wanted.thread_count) {
      const hl_untangled several = untangled(&cells, &wanted);
      CHECK(memcmp(first, moved, sizeof first) == 0, "%d, %zu threads: other bits", n, wanted.thread_count);
      CHECK(several.place_count == one.place_count && several.sweep_count == one.sweep_count &&
                several.below_after == one.below_after && several.invalid_after == one.invalid_after,
            "%d, %zu threads: other counts", n, wanted.thread_count);
    }
    CHECK(pieces > 3, "%zu pieces", pieces);
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

static void exchange_bottom_and_top(int c) {
  for (int v = 0; v < 4; ++v) {
    const uint32_t bottom = indices[8 * c + v];
    indices[8 * c + v] = indices[8 * c + v + 4];
    indices[8 * c + v + 4] = bottom;
  }
}

static void expect_reversed(const hl_cells *cells, const uint8_t expected[CELLS], const char *what) {
  static uint8_t reversed[CELLS];
  const size_t room = hl_untangle_room(POINTS, CELLS, 1);
  void *memory = malloc(room);
  CHECK(hl_reversed_cells(cells, memory, room, reversed) == HL_OK, "status");
  free(memory);
  CHECK(memcmp(reversed, expected, CELLS) == 0, "%s", what);
}

static void finds_reversed_cells(void) {
  static uint8_t expected[CELLS];
  const hl_cells cells = noisy_grid(0.1);
  memset(expected, 0, sizeof expected);
  expect_reversed(&cells, expected, "as it is");
  for (int part = 2; part < 10; part += 3) {
    noisy_grid(0.1);
    for (int c = 0; c < CELLS; ++c) {
      expected[c] = random_unit(&stream) < part / 10.0;
      if (expected[c]) exchange_bottom_and_top(c);
    }
    expect_reversed(&cells, expected, "some");
  }
  noisy_grid(0.1);
  for (int c = 0; c < CELLS; ++c) exchange_bottom_and_top(c);
  memset(expected, 1, sizeof expected);
  expect_reversed(&cells, expected, "all");
  for (int i = 0; i < 3 * POINTS; i += 3) given[i] = -given[i];
  memset(expected, 0, sizeof expected);
  expect_reversed(&cells, expected, "all in a mirror");
  given[3 * (POINTS / 2)] = NAN;
  expect_reversed(&cells, expected, "not finite");
}

/* Cells that are inside out because their points lie so are for moves to mend. */
static void leaves_folded_cells(void) {
  static uint8_t expected[CELLS];
  const hl_cells cells = noisy_grid(0);
  for (int p = 0; p < POINTS; ++p)
    if (is_inside(p)) given[3 * p] = SIDE - given[3 * p];
  memset(expected, 0, sizeof expected);
  CHECK(invalid_count(given) > CELLS / 3, "%zu", invalid_count(given));
  expect_reversed(&cells, expected, "folded");
  const int corner = 0, inside = CELLS / 2;
  exchange_bottom_and_top(corner);
  exchange_bottom_and_top(inside);
  /* The cell inside is valid as it is now. */
  expected[corner] = 1;
  expect_reversed(&cells, expected, "folded, two reversed");
}

/* A ring of three cells that is closed with half a turn cannot be numbered alike. */
static void leaves_what_has_no_way_round(void) {
  static const uint32_t ring[3][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}};
  uint8_t reversed[3];
  uint32_t own[24];
  double points[36];
  for (int i = 0; i < 36; ++i) points[i] = random_normal(&stream);
  for (int c = 0; c < 3; ++c)
    for (int v = 0; v < 4; ++v) {
      own[8 * c + v] = ring[c][v];
      own[8 * c + v + 4] = ring[(c + 1) % 3][c == 2 ? 3 - v : v];
    }
  const hl_cells cells = {points, 36, own, 24};
  const size_t room = hl_untangle_room(12, 3, 1);
  void *memory = malloc(room);
  CHECK(hl_reversed_cells(&cells, memory, room, reversed) == HL_OK, "status");
  for (int c = 0; c < 3; ++c) CHECK(reversed[c] == 0, "%d", c);
  free(memory);
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
  RUN(slides_in_planes);
  RUN(keeps_the_distance);
  RUN(threads_do_not_matter);
  RUN(is_the_same_again);
  RUN(leaves_what_is_fixed_and_stops);
  RUN(finds_reversed_cells);
  RUN(leaves_folded_cells);
  RUN(leaves_what_has_no_way_round);
  RUN(refuses_what_is_no_mesh);
  return test_summary();
}
