/* Cells by indices of points: which cells are around a point, and which points are on the boundary. */
#ifndef HL_MESH_H
#define HL_MESH_H

#include "hexlens.h"

/* The cells of point p are around[first[p]] to around[first[p + 1] - 1], each once. */
typedef struct mesh {
  const uint32_t *indices;
  size_t point_count, cell_count;
  double *points;
  uint32_t *first;  /* point_count + 1 */
  uint32_t *around; /* eight a cell */
} mesh;

/* Refuses what is no mesh; its lists and points are left to the caller. */
hl_status read_mesh(const hl_cells *cells, mesh *m);

void find_cells_around(const mesh *m);

/* 1 for the points of faces that are not shared by exactly two cells. */
void mark_boundary(const mesh *m, uint8_t *boundary);

/* The vertices of a face in no order that matters. */
void face_points(const uint32_t *cell, int face, uint32_t points[4]);

/* True if the cell has all four points. */
bool has_points(const uint32_t *cell, const uint32_t points[4]);

/* How many other cells have all points of a face of cell c. */
int cells_beyond(const mesh *m, size_t c, const uint32_t points[4]);

#endif
