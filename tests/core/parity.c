/* Reads hexahedra as raw doubles, 24 each, from standard input. Without an argument it writes for each its status and its packed report,
   minimum, verdict and Jacobian as raw doubles; with `batch` the twelve lists of hl_classify for all of them, one after the
   other as they lie in memory: what tests/unit/parity.test.ts compares with the wasm's memory. With `places` each eight of them are a star
   whose moving vertex is the first one's vertex 6, and all that is written is the packed best places: tests/unit/best-place.test.ts. */
#include "hexlens.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void write_doubles(const double *values, size_t count) { fwrite(values, sizeof(double), count, stdout); }

static void one_by_one(void) {
  static double packed[HL_PACKED_REPORT];
  static hl_report report;
  double vertices[HL_COORDINATES];
  const double point[3] = {0.25, 0.625, 0.8125};
  while (fread(vertices, sizeof vertices, 1, stdin) == 1) {
    double status = hl_analyze(vertices, &report);
    write_doubles(&status, 1);
    if (status != HL_OK) continue;
    write_doubles(packed, hl_pack_report(&report, packed));
    for (int variant = HL_ROOTS; variant <= HL_ROOTS_B; ++variant) {
      hl_minimum minimum;
      hl_boundary_minimum(vertices, (hl_variant)variant, &minimum);
      write_doubles(packed, hl_pack_minimum(&minimum, packed));
    }
    hl_verdict verdict = HL_UNANSWERED;
    hl_decide(vertices, &verdict);
    double number = verdict;
    write_doubles(&number, 1);
    hl_jacobian jacobian;
    hl_jacobian_at(vertices, point, &jacobian);
    write_doubles(packed, hl_pack_jacobian(&jacobian, packed));
  }
}

enum { LISTS = 12 };

static void as_a_batch(void) {
  size_t count = 0, room = 1024;
  double *points = malloc(room * HL_COORDINATES * sizeof *points);
  while (fread(points + HL_COORDINATES * count, sizeof *points, HL_COORDINATES, stdin) == HL_COORDINATES)
    if (++count == room) points = realloc(points, (room *= 2) * HL_COORDINATES * sizeof *points);
  const size_t each[LISTS] = {1, 1, 1, 1, 2, 8, 24, 8, 2, 8, 8, 2};
  void *at[LISTS];
  for (int i = 0; i < LISTS; ++i) at[i] = malloc(each[i] * count);
  hl_batch batch = {at[0], at[1],  at[2],  at[3], at[4], at[5], at[6], at[7], at[8],
                    at[9], at[10], at[11], 0,     0,     0,     0,     0};
  hl_cells cells = {points, HL_COORDINATES * count, NULL, 0};
  if (hl_classify(&cells, &batch) != HL_OK) exit(1);
  for (int i = 0; i < LISTS; ++i) {
    fwrite(at[i], each[i], count, stdout);
    free(at[i]);
  }
  free(points);
}

enum { STAR = 8 };

static void best_places(void) {
  static double blocks[STAR * HL_COORDINATES], packed[HL_PACKED_PLACE];
  const size_t room = hl_best_place_room(STAR);
  void *memory = malloc(room);
  while (fread(blocks, sizeof blocks, 1, stdin) == 1) {
    uint8_t moving[STAR] = {0};
    for (int v = 0; v < STAR * HL_VERTICES; ++v)
      if (memcmp(blocks + 3 * v, blocks + 3 * 6, 3 * sizeof *blocks) == 0)
        moving[v / HL_VERTICES] = (uint8_t)(moving[v / HL_VERTICES] | 1u << v % HL_VERTICES);
    const hl_star star = {{blocks, STAR * HL_COORDINATES, NULL, 0}, moving, 0, NULL};
    hl_place place;
    if (hl_best_place(&star, memory, room, &place) != HL_OK) exit(1);
    write_doubles(packed, hl_pack_place(&place, packed));
  }
  free(memory);
}

int main(int count, char **words) {
  if (count > 1 && strcmp(words[1], "batch") == 0) as_a_batch();
  else if (count > 1 && strcmp(words[1], "places") == 0) best_places();
  else one_by_one();
  return 0;
}
