/* Best places, timed. Reads stars of eight cells as raw doubles, 24 a cell, the moving vertex the first cell's vertex 6; writes for each the
   least seconds of some runs, then value, bound, 1 by volume or 0 by scale, and the position. */
#include "hexlens.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { CELLS = 8, RUNS = 15 };

static double seconds(void) {
  struct timespec now;
  timespec_get(&now, TIME_UTC);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(void) {
  static double blocks[CELLS * HL_COORDINATES];
  const size_t room = hl_best_place_room(CELLS);
  void *memory = malloc(room);
  while (fread(blocks, sizeof blocks, 1, stdin) == 1) {
    uint8_t moving[CELLS] = {0};
    for (int v = 0; v < CELLS * HL_VERTICES; ++v)
      if (memcmp(blocks + 3 * v, blocks + 3 * 6, 3 * sizeof *blocks) == 0)
        moving[v / HL_VERTICES] = (uint8_t)(moving[v / HL_VERTICES] | 1u << v % HL_VERTICES);
    const hl_star star = {{blocks, CELLS * HL_COORDINATES, NULL, 0}, moving, 0, NULL};
    hl_place place = {.bound = 0};
    double least = 1;
    for (int run = 0; run < RUNS; ++run) {
      const double start = seconds();
      if (hl_best_place(&star, memory, room, &place) != HL_OK) return 1;
      const double taken = seconds() - start;
      if (taken < least) least = taken;
    }
    const double answer[] = {least,
                             place.value,
                             place.bound,
                             place.measure == HL_BY_VOLUME,
                             place.position[0],
                             place.position[1],
                             place.position[2]};
    fwrite(answer, sizeof answer, 1, stdout);
  }
  free(memory);
  return 0;
}
