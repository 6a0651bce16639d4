/* Cells whose nodes are numbered the other way round: docs/repair.md 9. */
#include "reversed.h"
#include "report.h"
#include "scaling.h"
#include "topology.h"

#include <math.h>
#include <string.h>

/* The state of a cell while its component is walked through, as bits of its entry in the result. */
enum { IS_REACHED = 1, IS_AGAINST_FIRST = 2 };

/* The points of a face, round it: to the left as it is seen from outside, if jacdet > 0. */
static void face_loop(const uint32_t *cell, int face, uint32_t loop[4]) {
  static const unsigned char along[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const int axis = face_table[face].axis, side = face_table[face].side;
  /* s, t and the face's axis are a right-handed frame but for the axis 1. */
  const bool is_left = (side == 1) != (axis == 1);
  for (int i = 0; i < 4; ++i) {
    int at[3];
    at[axis] = side;
    at[face_table[face].s] = along[is_left ? i : 3 - i][0];
    at[face_table[face].t] = along[is_left ? i : 3 - i][1];
    loop[i] = cell[vertex_at[at[0]][at[1]][at[2]]];
  }
}

static bool has_four(const uint32_t loop[4]) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      if (loop[i] == loop[j]) return false;
  return true;
}

/* 1 if the cell has a face of these points round it in this direction, -1 in the other, else 0. */
static int direction_in(const uint32_t *cell, const uint32_t loop[4]) {
  for (int f = 0; f < HL_FACES; ++f) {
    uint32_t own[4];
    face_loop(cell, f, own);
    for (int start = 0; start < 4; ++start) {
      if (own[start] != loop[0] || own[(start + 2) & 3] != loop[2]) continue;
      if (own[(start + 1) & 3] == loop[1] && own[(start + 3) & 3] == loop[3]) return 1;
      if (own[(start + 3) & 3] == loop[1] && own[(start + 1) & 3] == loop[3]) return -1;
    }
  }
  return 0;
}

/* The only other cell with a face of these points, and its direction; 0 if there is none, or several. */
static int beyond(const mesh *m, size_t c, const uint32_t loop[4], uint32_t *other) {
  int found = 0;
  for (uint32_t i = m->first[loop[0]]; i < m->first[loop[0] + 1]; ++i) {
    const uint32_t *cell = m->indices + HL_VERTICES * (size_t)m->around[i];
    const int direction = m->around[i] != c && has_points(cell, loop) ? direction_in(cell, loop) : 0;
    if (direction == 0) continue;
    if (found != 0) return 0;
    found = direction;
    *other = m->around[i];
  }
  return found;
}

/* Cells that hang together by faces, from `first` on, into `queue`; their number. `agrees` is false if they cannot all be numbered the
   same way round. */
static size_t walk(const mesh *m, uint32_t first, uint8_t *marks, uint32_t *queue, bool *agrees) {
  size_t count = 0;
  queue[count++] = first;
  marks[first] = IS_REACHED;
  *agrees = true;
  for (size_t at = 0; at < count; ++at)
    for (int f = 0; f < HL_FACES; ++f) {
      const uint32_t c = queue[at];
      uint32_t loop[4], other;
      face_loop(m->indices + HL_VERTICES * (size_t)c, f, loop);
      const int direction = has_four(loop) ? beyond(m, c, loop, &other) : 0;
      if (direction == 0) continue;
      /* Two cells that are numbered the same way go round the face between them in opposite directions. */
      const uint8_t mark = (uint8_t)(direction > 0 ? marks[c] ^ IS_AGAINST_FIRST : marks[c]);
      if (marks[other] == 0) {
        marks[other] = mark;
        queue[count++] = other;
      } else if (marks[other] != mark) *agrees = false;
    }
  return count;
}

static scaled_double volume_of(const mesh *m, const double *coordinates, size_t c) {
  double vertices[HL_COORDINATES];
  for (int v = 0; v < HL_VERTICES; ++v)
    memcpy(vertices + 3 * v, coordinates + 3 * (size_t)m->indices[HL_VERTICES * c + (size_t)v], 3 * sizeof *vertices);
  return all_finite(vertices, HL_COORDINATES) ? find_volume(vertices) : (scaled_double){NAN, 0};
}

/* The volumes of the cells in a unit of their own: what has no room there makes the sum uncertain. */
static void find_volumes(const mesh *m, const double *coordinates, const uint32_t *queue, size_t count,
                         double *volumes) {
  int unit = 0;
  bool has_unit = false;
  for (size_t i = 0; i < count; ++i) {
    const scaled_double volume = volume_of(m, coordinates, queue[i]);
    if (!has_unit && volume.mantissa != 0) {
      unit = volume.exponent;
      has_unit = true;
    }
    volumes[queue[i]] = volume.mantissa == volume.mantissa ? in_normal_units(volume, unit) : NAN;
  }
}

/* The sign of the volume of all, numbered as the first of them; 0 if that is not certain: (R18). */
static int sign_of_all(const double *volumes, const uint8_t *marks, const uint32_t *queue, size_t count) {
  double sum = 0, size = 0;
  for (size_t i = 0; i < count; ++i) {
    const double volume = volumes[queue[i]];
    sum += marks[queue[i]] & IS_AGAINST_FIRST ? -volume : volume;
    size += fabs(volume);
  }
  if (!(fabs(sum) > 0x1p-52 * (double)count * size)) return 0;
  return sum > 0 ? 1 : -1;
}

void find_reversed(const mesh *m, const double *coordinates, double *volumes, uint32_t *queue, uint8_t *reversed) {
  memset(reversed, 0, m->cell_count);
  for (size_t first = 0; first < m->cell_count; ++first) {
    if (reversed[first] != 0) continue;
    bool agrees;
    const size_t count = walk(m, (uint32_t)first, reversed, queue, &agrees);
    find_volumes(m, coordinates, queue, count, volumes);
    const int sign = agrees ? sign_of_all(volumes, reversed, queue, count) : 0;
    for (size_t i = 0; i < count; ++i) {
      const bool is_wrong = sign != 0 && ((reversed[queue[i]] & IS_AGAINST_FIRST) != 0) == (sign > 0);
      /* A cell with a positive volume is never mirrored by this. */
      volumes[queue[i]] = is_wrong && volumes[queue[i]] < 0;
    }
  }
  for (size_t c = 0; c < m->cell_count; ++c) reversed[c] = volumes[c] != 0;
}
