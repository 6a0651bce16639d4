/* F and its Jacobian at a reference point: docs/algorithm.md (1) and (2). */
#include "map.h"
#include "bernstein.h"
#include "hexlens.h"
#include "topology.h"

void map_point(const double vertices[24], const double point[3], double position[3]) {
  const double xi = point[0], eta = point[1], zeta = point[2];
  for (int r = 0; r < 3; ++r) {
    const double *p = vertices + r;
    double bottom = lerp(lerp(p[3 * vertex_at[0][0][0]], p[3 * vertex_at[1][0][0]], xi),
                         lerp(p[3 * vertex_at[0][1][0]], p[3 * vertex_at[1][1][0]], xi), eta);
    double top = lerp(lerp(p[3 * vertex_at[0][0][1]], p[3 * vertex_at[1][0][1]], xi),
                      lerp(p[3 * vertex_at[0][1][1]], p[3 * vertex_at[1][1][1]], xi), eta);
    position[r] = lerp(bottom, top, zeta) + 0.0; /* -0 becomes 0 */
  }
}

/* F is linear on edges. */
void map_candidate(const double vertices[24], hl_candidate *candidate) {
  int from = candidate->id, to = from;
  double t = 0;
  if (candidate->kind == HL_FACE) {
    map_point(vertices, candidate->point, candidate->position);
    return;
  }
  if (candidate->kind == HL_EDGE) {
    from = edge_ends[candidate->id][0];
    to = edge_ends[candidate->id][1];
    t = candidate->point[edge_table[candidate->id].axis];
  }
  for (int r = 0; r < 3; ++r) candidate->position[r] = lerp(vertices[3 * from + r], vertices[3 * to + r], t) + 0.0;
}

/* A column is the bilinear mean of its four edge vectors over the two other coordinates, in ascending order. */
void jacobian_columns(const edge_vectors *edges, const double point[3], double columns[3][3]) {
  const double (*const families[3])[2][3] = {edges->u, edges->v, edges->w};
  for (int c = 0; c < 3; ++c) {
    double first = point[c == 0 ? 1 : 0], second = point[c == 2 ? 1 : 2];
    for (int r = 0; r < 3; ++r)
      columns[c][r] = lerp(lerp(families[c][0][0][r], families[c][1][0][r], first),
                           lerp(families[c][0][1][r], families[c][1][1][r], first), second) +
                      0.0;
  }
}

hl_status hl_jacobian_at(const double vertices[24], const double point[3], hl_jacobian *jacobian) {
  if (!all_finite(vertices, HL_COORDINATES) || !all_finite(point, 3)) return HL_NOT_FINITE;
  for (int axis = 0; axis < 3; ++axis)
    if (point[axis] < 0 || point[axis] > 1) return HL_OUTSIDE_CUBE;
  edge_vectors edges;
  double columns[3][3], normal[3];
  scaled_edge_vectors(vertices, &edges);
  jacobian_columns(&edges, point, columns);
  cross(columns[0], columns[1], normal);
  jacobian->jacdet = dot(normal, columns[2]) + 0.0;
  jacobian->exponent = scaled_back(&jacobian->jacdet, 1, jacdet_exponent(&edges));
  for (int r = 0; r < 3; ++r) {
    double row[3] = {columns[0][r], columns[1][r], columns[2][r]};
    jacobian->axis_exponent[r] = scaled_back(row, 3, edges.axis_exponent[r]);
    for (int c = 0; c < 3; ++c) jacobian->columns[c][r] = row[c];
  }
  map_point(vertices, point, jacobian->position);
  return HL_OK;
}
