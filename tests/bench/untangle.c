/* Sweeps of best places, timed, on grids of unit spacing whose interior vertices are moved. Prints a line for each of the grids below;
   with a number N it writes grid N instead: the counts of points and cells, all coordinates, all indices. */
#include "../core/random.h"
#include "hexlens.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* Normal noise of all, and noise 1 of a part; turned about the axis of the cube by so many right angles in the middle; folded so that
   the middle third along x runs backwards. */
typedef struct moved_grid {
  const char *name;
  int side;
  double margin, sigma, thrown;
  double turn;
  bool is_folded;
} moved_grid;

static const moved_grid grids[] = {
    {"noise 0.145", 46, 0.1, 0.145, 0, 0, false},
    {"noise 0.16", 46, 0.1, 0.16, 0, 0, false},
    {"noise 0.165", 46, 0.1, 0.165, 0, 0, false},
    {"noise 0.2", 20, 0.1, 0.2, 0, 0, false},
    {"noise 0.3", 20, 0, 0.3, 0, 0, false},
    {"10 % thrown", 20, 0, 0.05, 0.1, 0, false},
    {"20 % thrown", 20, 0, 0.05, 0.2, 0, false},
    {"30 % thrown", 20, 0, 0.05, 0.3, 0, false},
    {"40 % thrown", 20, 0, 0.05, 0.4, 0, false},
    {"50 % thrown", 20, 0, 0.05, 0.5, 0, false},
    {"twisted by 180 degrees", 20, 0, 0, 0, 2, false},
    {"folded", 20, 0, 0, 0, 0, true},
};
enum { GRIDS = sizeof grids / sizeof *grids };

/* Hard ones take thousands of sweeps. */
enum { MOST_PLACES = 100000 };

static bool goes_on(void *context, const hl_untangled *so_far) {
  (void)context;
  return so_far->place_count < MOST_PLACES;
}

/* A point's angle falls from the middle to the boundary, as the cosines over the three axes. */
static void twist(const moved_grid *g, double *p) {
  const double half = 0.5 * g->side, pi = 3.14159265358979323846;
  double angle = g->turn * 0.5 * pi;
  for (int r = 0; r < 3; ++r) angle *= cos(0.5 * pi * (p[r] - half) / half);
  const double x = p[0] - half, y = p[1] - half;
  p[0] = half + cos(angle) * x - sin(angle) * y;
  p[1] = half + sin(angle) * x + cos(angle) * y;
}

/* From 0 to 2/3, back to 1/3, on to 1. */
static void fold(const moved_grid *g, double *p) {
  const double t = p[0] / g->side, third = 1. / 3;
  p[0] = g->side * (t < third ? 2 * t : t < 2 * third ? 1 - t : 2 * t - 1);
}

static void fill(const moved_grid *g, double *points, uint32_t *indices) {
  static const int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  random_stream stream = {7};
  const int n = g->side, edge = n + 1;
  for (int p = 0; p < edge * edge * edge; ++p) {
    const int at[3] = {p % edge, p / edge % edge, p / edge / edge};
    bool inside = true;
    for (int r = 0; r < 3; ++r) inside = inside && at[r] > 0 && at[r] < n;
    const double sigma = random_unit(&stream) < g->thrown ? 1 : g->sigma;
    double *point = points + 3 * p;
    for (int r = 0; r < 3; ++r) point[r] = at[r] + (inside ? sigma * random_normal(&stream) : 0);
    if (inside) twist(g, point);
    if (inside && g->is_folded) fold(g, point);
  }
  for (int c = 0; c < n * n * n; ++c)
    for (int v = 0; v < 8; ++v) {
      const int *o = corner[v];
      indices[8 * c + v] = (uint32_t)(c % n + o[0] + edge * (c / n % n + o[1] + edge * (c / n / n + o[2])));
    }
}

static void print_repair(const moved_grid *g, const hl_cells *cells, double *moved) {
  const size_t room = hl_untangle_room(cells->coordinate_count / 3, cells->index_count / 8, 1);
  void *memory = malloc(room);
  const hl_untangling wanted = {.margin = g->margin, .proceed = goes_on};
  hl_untangled result;
  const clock_t start = clock();
  if (hl_untangle(cells, &wanted, memory, room, moved, &result) != HL_OK) exit(1);
  const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
  printf("%-23s %6zu cells, margin %-4g %5zu invalid, then %5zu; %5zu below, then %5zu; moved %.2f on average; %6zu best places, "
         "%2zu sweeps, %.2f s%s\n",
         g->name, cells->index_count / 8, g->margin, result.invalid_before, result.invalid_after, result.below_before,
         result.below_after, result.mean_distance, result.place_count, result.sweep_count, seconds,
         result.is_stopped ? ", stopped" : "");
  free(memory);
}

int main(int count, char **words) {
  const int only = count > 1 ? atoi(words[1]) : -1;
  for (int i = 0; i < GRIDS; ++i) {
    if (only >= 0 && i != only) continue;
    const moved_grid *g = &grids[i];
    const size_t n = (size_t)g->side, point_count = (n + 1) * (n + 1) * (n + 1), cell_count = n * n * n;
    double *points = malloc(3 * point_count * sizeof *points), *moved = malloc(3 * point_count * sizeof *moved);
    uint32_t *indices = malloc(8 * cell_count * sizeof *indices);
    fill(g, points, indices);
    const hl_cells cells = {points, 3 * point_count, indices, 8 * cell_count};
    if (only < 0) print_repair(g, &cells, moved);
    else {
      const uint64_t counts[2] = {point_count, cell_count};
      fwrite(counts, sizeof counts, 1, stdout);
      fwrite(points, sizeof *points, 3 * point_count, stdout);
      fwrite(indices, sizeof *indices, 8 * cell_count, stdout);
    }
    free(points);
    free(moved);
    free(indices);
  }
  return 0;
}
