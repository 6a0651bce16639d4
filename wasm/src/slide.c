/* Where a boundary point of a mesh may go: in the planes of its boundary faces, or within a distance. docs/repair.md (R15), (R16). */
#include "slide.h"
#include "bernstein.h"
#include "topology.h"

#include <math.h>
#include <string.h>

/* (R15): 1/sqrt(3), less 2e-14 of itself for the roundings. */
#define HALF_SIDE 0.57735026918961
/* (R16): of the largest coordinate and the shape of the face's corner. */
#define PLANE_ERROR 0x1p-49
/* (R16): sine of the angle between two planes that leave a line. */
#define SAME_PLANE 0x1p-20

typedef struct planes {
  int count;
  double normals[2][3], shapes[2]; /* of length 1; (|e| + |f|) / |e x f| of the edges that they are from */
} planes;

/* A face at the point: its own edges e and f there, and the way to the vertex opposite. */
typedef struct corner {
  double ways[3][3];
} corner;

static corner corner_at(const double *given, const uint32_t *cell, int face, int v) {
  const int axis = face_table[face].axis;
  corner found;
  int n = 0;
  for (int other = 0; other < HL_VERTICES; ++other) {
    if (other == v || vertex_reference[other][axis] != vertex_reference[v][axis]) continue;
    int steps = 0;
    for (int r = 0; r < 3; ++r) steps += vertex_reference[other][r] != vertex_reference[v][r];
    double *way = found.ways[steps == 1 ? n++ : 2];
    for (int r = 0; r < 3; ++r)
      way[r] = given[3 * (size_t)cell[other] + (size_t)r] - given[3 * (size_t)cell[v] + (size_t)r];
  }
  return found;
}

static bool is_in_plane(const corner *c, const double normal[3], double shape, double extent) {
  for (int i = 0; i < 3; ++i) {
    const double reach = sqrt(dot(c->ways[i], c->ways[i]));
    if (!(fabs(dot(normal, c->ways[i])) <= PLANE_ERROR * extent * (1 + reach * shape))) return false;
  }
  return true;
}

/* The plane of the face is one of the planes, or becomes one. */
static bool has_plane(planes *found, const corner *c, double extent) {
  for (int i = 0; i < found->count; ++i)
    if (is_in_plane(c, found->normals[i], found->shapes[i], extent)) return true;
  if (found->count == 2) return false;
  double *normal = found->normals[found->count];
  cross(c->ways[0], c->ways[1], normal);
  const double length = sqrt(dot(normal, normal));
  if (!(length > 0x1p-1000)) return false;
  for (int r = 0; r < 3; ++r) normal[r] /= length;
  const double shape = (sqrt(dot(c->ways[0], c->ways[0])) + sqrt(dot(c->ways[1], c->ways[1]))) / length;
  found->shapes[found->count++] = shape;
  return is_in_plane(c, normal, shape, extent);
}

static bool is_axis(const double n[3]) { return (n[0] != 0) + (n[1] != 0) + (n[2] != 0) == 1; }

static bool sliding_normals(const mesh *m, const double *given, uint32_t p, double normals[2][3]) {
  planes found = {.count = 0};
  double extent = 0;
  for (uint32_t i = m->first[p]; i < m->first[p + 1]; ++i)
    for (int v = 0; v < HL_VERTICES; ++v)
      extent =
          larger(extent,
                 greatest_magnitude(given + 3 * (size_t)m->indices[HL_VERTICES * (size_t)m->around[i] + (size_t)v], 3));
  for (uint32_t i = m->first[p]; i < m->first[p + 1]; ++i) {
    const uint32_t *cell = m->indices + HL_VERTICES * (size_t)m->around[i];
    for (int v = 0; v < HL_VERTICES; ++v)
      for (int f = 0; f < HL_FACES && cell[v] == p; ++f) {
        if (vertex_reference[v][face_table[f].axis] != face_table[f].side) continue;
        uint32_t points[4];
        face_points(cell, f, points);
        const int others = cells_beyond(m, m->around[i], points);
        if (others == 1) continue;
        const corner c = corner_at(given, cell, f, v);
        if (others > 1 || !has_plane(&found, &c, extent)) return false;
      }
  }
  if (found.count == 2) {
    double line[3];
    cross(found.normals[0], found.normals[1], line);
    if (!(dot(line, line) > SAME_PLANE * SAME_PLANE)) return false;
  }
  const bool is_turned = found.count == 2 && is_axis(found.normals[1]);
  memset(normals, 0, 6 * sizeof(double));
  for (int i = 0; i < found.count; ++i)
    memcpy(normals[is_turned ? 1 - i : i], found.normals[i], sizeof found.normals[i]);
  return found.count > 0;
}

bool boundary_limits(const mesh *m, const double *given, const hl_untangling *wanted, uint32_t p, hl_limits *limits) {
  *limits = (hl_limits){.low = {-INFINITY, -INFINITY, -INFINITY}, .high = {INFINITY, INFINITY, INFINITY}};
  const bool is_near = wanted->boundary_distance > 0;
  if (wanted->slides && sliding_normals(m, given, p, limits->normals)) {
    if (!is_near) return true;
  } else {
    memset(limits->normals, 0, sizeof limits->normals);
    if (!is_near) return false;
  }
  const double half = wanted->boundary_distance * HALF_SIDE;
  for (int r = 0; r < 3; ++r) {
    const double x = given[3 * (size_t)p + (size_t)r];
    limits->low[r] = nextafter(x - half, x);
    limits->high[r] = nextafter(x + half, x);
  }
  return true;
}
