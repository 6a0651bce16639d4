/* The points of the boundary that may be the minimizer: docs/algorithm.md (9) to (11). */
#include "candidates.h"
#include "bernstein.h"
#include "topology.h"

hl_candidate vertex_candidate(const double bernstein[27], int vertex) {
  const unsigned char *r = vertex_reference[vertex];
  return (hl_candidate){
      .kind = HL_VERTEX, .id = vertex, .point = {r[0], r[1], r[2]}, .value = bernstein[vertex_index(vertex)]};
}

bool edge_candidate(const double bernstein[27], int edge, double bound, hl_candidate *candidate) {
  int axis = edge_table[edge].axis, from = edge_table[edge].from;
  const double *q = bernstein + vertex_index(from);
  double q0 = q[0], q1 = q[axis_stride[axis]], q2 = q[2 * axis_stride[axis]];
  double fall = q0 - q1, rise = q2 - q1;
  if (!(fall > 0 && rise > 0)) return false;
  double r = fall / (fall + rise);
  if (!(r > 0 && r < 1)) return false;
  double value = quadratic_at(q0, q1, q2, r);
  if (!(value < bound)) return false;
  const unsigned char *start = vertex_reference[from];
  *candidate = (hl_candidate){.kind = HL_EDGE, .id = edge, .point = {start[0], start[1], start[2]}, .value = value};
  candidate->point[axis] = r;
  return true;
}

hl_candidate face_candidate(int face, const face_solution *solution, int root) {
  hl_candidate candidate = {.kind = HL_FACE, .id = face, .value = solution->values[root]};
  candidate.point[face_table[face].axis] = face_table[face].side;
  candidate.point[face_table[face].s] = solution->roots[root].s;
  candidate.point[face_table[face].t] = solution->roots[root].t;
  return candidate;
}
