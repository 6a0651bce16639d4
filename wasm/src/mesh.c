/* Which cells are around a point, and which points are on the boundary. */
#include "mesh.h"
#include "topology.h"

#include <string.h>

hl_status read_mesh(const hl_cells *cells, mesh *m) {
  if (!cells->indices) return HL_MISSING_LIST;
  if (cells->index_count % HL_VERTICES != 0 || cells->coordinate_count % 3 != 0) return HL_INCOMPLETE;
  *m = (mesh){.indices = cells->indices,
              .point_count = cells->coordinate_count / 3,
              .cell_count = cells->index_count / HL_VERTICES};
  for (size_t i = 0; i < cells->index_count; ++i)
    if (cells->indices[i] >= m->point_count) return HL_NO_SUCH_POINT;
  return HL_OK;
}

/* A cell that has a point more than once is in its list once. */
static bool is_first_of(const uint32_t *cell, int v) {
  for (int u = 0; u < v; ++u)
    if (cell[u] == cell[v]) return false;
  return true;
}

void find_cells_around(const mesh *m) {
  memset(m->first, 0, (m->point_count + 1) * sizeof(uint32_t));
  uint32_t total = 0;
  for (size_t c = 0; c < m->cell_count; ++c)
    for (int v = 0; v < HL_VERTICES; ++v) {
      const uint32_t *cell = m->indices + HL_VERTICES * c;
      if (!is_first_of(cell, v)) continue;
      ++m->first[cell[v] + 1];
      ++total;
    }
  for (size_t p = 0; p < m->point_count; ++p) m->first[p + 1] += m->first[p];
  for (size_t c = m->cell_count; c-- > 0;)
    for (int v = 0; v < HL_VERTICES; ++v) {
      const uint32_t *cell = m->indices + HL_VERTICES * c;
      if (is_first_of(cell, v)) m->around[--m->first[cell[v] + 1]] = (uint32_t)c;
    }
  /* Each entry is now the beginning of its point's list, one place too high. */
  memmove(m->first, m->first + 1, m->point_count * sizeof(uint32_t));
  m->first[m->point_count] = total;
}

void face_points(const uint32_t *cell, int face, uint32_t points[4]) {
  for (int v = 0, n = 0; v < HL_VERTICES; ++v)
    if (vertex_reference[v][face_table[face].axis] == face_table[face].side) points[n++] = cell[v];
}

bool has_points(const uint32_t *cell, const uint32_t points[4]) {
  for (int i = 0; i < 4; ++i) {
    bool is_found = false;
    for (int v = 0; v < HL_VERTICES; ++v) is_found = is_found || cell[v] == points[i];
    if (!is_found) return false;
  }
  return true;
}

int cells_beyond(const mesh *m, size_t c, const uint32_t points[4]) {
  int others = 0;
  for (uint32_t i = m->first[points[0]]; i < m->first[points[0] + 1]; ++i)
    others += m->around[i] != c && has_points(m->indices + HL_VERTICES * (size_t)m->around[i], points);
  return others;
}

void mark_boundary(const mesh *m, uint8_t *boundary) {
  memset(boundary, 0, m->point_count);
  for (size_t c = 0; c < m->cell_count; ++c)
    for (int f = 0; f < HL_FACES; ++f) {
      uint32_t points[4];
      face_points(m->indices + HL_VERTICES * c, f, points);
      if (cells_beyond(m, c, points) == 1) continue;
      for (int v = 0; v < 4; ++v) boundary[points[v]] = 1;
    }
}
