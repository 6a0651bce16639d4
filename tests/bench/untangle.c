/* Sweeps of best places, timed, on grids of unit spacing with normal noise of the interior vertices. Prints a line for each of the grids
   below. */
#include "../core/random.h"
#include "hexlens.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* A part of the vertices has noise 1; so many best places at most, since hard ones take thousands of sweeps. */
typedef struct noisy_grid {
  int side;
  double sigma, part, margin;
} noisy_grid;

static const noisy_grid grids[] = {{46, 0.145, 0, 0.1}, {46, 0.16, 0, 0.1}, {46, 0.165, 0, 0.1}, {20, 0.2, 0, 0.1},
                                   {20, 0.3, 0, 0},     {20, 0.05, 0.1, 0.1}, {20, 0.05, 0.5, 0.1}};
enum { MOST_PLACES = 60000 };

static bool goes_on(void *context, const hl_untangled *so_far) {
  (void)context;
  return so_far->place_count < MOST_PLACES;
}

static void fill(const noisy_grid *g, double *points, uint32_t *indices) {
  static const int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  random_stream stream = {7};
  const int n = g->side, edge = n + 1;
  for (int p = 0; p < edge * edge * edge; ++p) {
    const int at[3] = {p % edge, p / edge % edge, p / edge / edge};
    bool inside = true;
    for (int r = 0; r < 3; ++r) inside = inside && at[r] > 0 && at[r] < n;
    const double sigma = random_unit(&stream) < g->part ? 1 : g->sigma;
    for (int r = 0; r < 3; ++r) points[3 * p + r] = at[r] + (inside ? sigma * random_normal(&stream) : 0);
  }
  for (int c = 0; c < n * n * n; ++c)
    for (int v = 0; v < 8; ++v) {
      const int *o = corner[v];
      indices[8 * c + v] = (uint32_t)(c % n + o[0] + edge * (c / n % n + o[1] + edge * (c / n / n + o[2])));
    }
}

int main(void) {
  for (size_t i = 0; i < sizeof grids / sizeof *grids; ++i) {
    const noisy_grid *g = &grids[i];
    const size_t n = (size_t)g->side, point_count = (n + 1) * (n + 1) * (n + 1), cell_count = n * n * n;
    const size_t room = hl_untangle_room(point_count, cell_count, 1);
    double *points = malloc(3 * point_count * sizeof *points), *moved = malloc(3 * point_count * sizeof *moved);
    uint32_t *indices = malloc(8 * cell_count * sizeof *indices);
    void *memory = malloc(room);
    fill(g, points, indices);
    const hl_cells cells = {points, 3 * point_count, indices, 8 * cell_count};
    const hl_untangling wanted = {.margin = g->margin, .proceed = goes_on};
    hl_untangled result;
    const clock_t start = clock();
    if (hl_untangle(&cells, &wanted, memory, room, moved, &result) != HL_OK) return 1;
    const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    printf("%zu cells, noise %g, %g of the vertices 1, margin %g: %zu invalid, then %zu; %zu best places, %zu sweeps, %.2f s%s\n",
           cell_count, g->sigma, g->part, g->margin, result.invalid_before, result.invalid_after, result.place_count,
           result.sweep_count, seconds, result.is_stopped ? ", stopped" : "");
    free(points);
    free(moved);
    free(indices);
    free(memory);
  }
  return 0;
}
