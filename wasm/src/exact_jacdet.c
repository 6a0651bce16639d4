/* Bernstein coefficients of jacdet as integers: docs/algorithm.md (3) to (7). */
#include "exact_jacdet.h"
#include "report.h"
#include "topology.h"

#include <limits.h>

/* The coordinates of some vertices as integers over one power of two for each axis. */
typedef struct integer_points {
  integer p[HL_VERTICES][3];
  int exponents[3];
} integer_points;

enum { ALL_VERTICES = (1 << HL_VERTICES) - 1 };

static void integer_coordinates(workspace *w, const double vertices[24], unsigned used, integer_points *out) {
  for (int axis = 0; axis < 3; ++axis) {
    int exponents[HL_VERTICES], least = INT_MAX;
    for (int v = 0; v < HL_VERTICES; ++v) {
      if (!(used >> v & 1)) continue;
      out->p[v][axis] = integer_of_double(w, vertices[3 * v + axis], &exponents[v]);
      if (!is_zero(out->p[v][axis]) && exponents[v] < least) least = exponents[v];
    }
    for (int v = 0; v < HL_VERTICES; ++v)
      if (used >> v & 1 && !is_zero(out->p[v][axis]))
        out->p[v][axis] = integer_shifted(w, out->p[v][axis], exponents[v] - least);
    out->exponents[axis] = least < INT_MAX ? least : 0;
  }
}

static int exponent_of(const integer_points *points) {
  return points->exponents[0] + points->exponents[1] + points->exponents[2];
}

static void difference(workspace *w, const integer_points *points, int to, int from, integer out[3]) {
  for (int axis = 0; axis < 3; ++axis) out[axis] = integer_difference(w, points->p[to][axis], points->p[from][axis]);
}

/* a1 b2 - a2 b1, and so on. */
static void cross_product(workspace *w, const integer a[3], const integer b[3], integer out[3]) {
  for (int r = 0; r < 3; ++r) {
    const int s = (r + 1) % 3, t = (r + 2) % 3;
    const size_t mark = w->used;
    out[r] = integer_difference(w, integer_product(w, a[s], b[t]), integer_product(w, a[t], b[s]));
    integer_keep(w, mark, &out[r], 1);
  }
}

static integer dot_product(workspace *w, const integer a[3], const integer b[3]) {
  const size_t mark = w->used;
  integer sum = integer_product(w, a[0], b[0]);
  for (int r = 1; r < 3; ++r) sum = integer_sum(w, sum, integer_product(w, a[r], b[r]));
  integer_keep(w, mark, &sum, 1);
  return sum;
}



int exact_vertex_sign(workspace *w, const double vertices[24], int vertex) {
  const int i = vertex_reference[vertex][0], j = vertex_reference[vertex][1], k = vertex_reference[vertex][2];
  const int ends[3][2] = {{vertex_at[0][j][k], vertex_at[1][j][k]},
                          {vertex_at[i][0][k], vertex_at[i][1][k]},
                          {vertex_at[i][j][0], vertex_at[i][j][1]}};
  unsigned used = 0;
  for (int axis = 0; axis < 3; ++axis) used |= 1u << ends[axis][0] | 1u << ends[axis][1];
  const size_t mark = w->used;
  integer_points points;
  integer columns[3][3], normal[3];
  integer_coordinates(w, vertices, used, &points);
  for (int axis = 0; axis < 3; ++axis) difference(w, &points, ends[axis][1], ends[axis][0], columns[axis]);
  cross_product(w, columns[0], columns[1], normal);
  const int sign = integer_sign(dot_product(w, normal, columns[2]));
  w->used = mark;
  return sign;
}

/* The twelve edge vectors, as in scaling.h. */
typedef struct exact_edges {
  integer u[2][2][3], v[2][2][3], w[2][2][3];
} exact_edges;

static void exact_edge_vectors(workspace *w, const integer_points *points, exact_edges *edges) {
  for (int m = 0; m < 2; ++m)
    for (int n = 0; n < 2; ++n) {
      difference(w, points, vertex_at[1][m][n], vertex_at[0][m][n], edges->u[m][n]);
      difference(w, points, vertex_at[m][1][n], vertex_at[m][0][n], edges->v[m][n]);
      difference(w, points, vertex_at[m][n][1], vertex_at[m][n][0], edges->w[m][n]);
    }
}

/* Corners, and twice the middles of edges, by (3) to (6): each corner adds what it has to the three edges that meet there. */
static void corners_and_edges(workspace *w, const exact_edges *e, integer bernstein[27]) {
  for (int i = 0; i < HL_BERNSTEIN; ++i) bernstein[i] = zero;
  for (int v = 0; v < HL_VERTICES; ++v) {
    const int i = vertex_reference[v][0], j = vertex_reference[v][1], k = vertex_reference[v][2];
    const integer *third[3] = {e->w[1 - i][j], e->w[i][1 - j], e->w[i][j]};
    integer normals[2][3];
    cross_product(w, e->u[j][k], e->v[i][k], normals[0]);
    cross_product(w, e->u[j][k], e->v[i][1 - k], normals[1]);
    bernstein[vertex_index(v)] = dot_product(w, normals[0], e->w[i][j]);
    for (int axis = 0; axis < 3; ++axis) {
      const int stride = axis_stride[axis], inwards = vertex_reference[v][axis] ? -stride : stride;
      integer *middle = &bernstein[vertex_index(v) + inwards];
      *middle = integer_sum(w, *middle, dot_product(w, normals[axis == 2], third[axis]));
    }
  }
}

static integer sum_of(workspace *w, const integer *terms, const unsigned char *indices, int count) {
  integer sum = terms[indices[0]];
  for (int i = 1; i < count; ++i) sum = integer_sum(w, sum, terms[indices[i]]);
  return sum;
}

/* Four times a face's centre, (7). */
static integer face_centre(workspace *w, const integer bernstein[27], int face) {
  const unsigned char *on = face_coefficients[face];
  return integer_difference(w, sum_of(w, bernstein, (const unsigned char[]){on[1], on[3], on[5], on[7]}, 4),
                            sum_of(w, bernstein, (const unsigned char[]){on[0], on[2], on[6], on[8]}, 4));
}

void exact_bernstein(workspace *w, const double vertices[24], exact_jacdet *jacdet) {
  const size_t mark = w->used;
  integer *b = jacdet->bernstein;
  integer_points points;
  exact_edges edges;
  integer_coordinates(w, vertices, ALL_VERTICES, &points);
  exact_edge_vectors(w, &points, &edges);
  corners_and_edges(w, &edges, b);
  for (int f = 0; f < HL_FACES; ++f) b[face_middle(f)] = face_centre(w, b, f);
  for (int v = 0; v < HL_VERTICES; ++v) b[vertex_index(v)] = integer_shifted(w, b[vertex_index(v)], 2);
  for (int e = 0; e < HL_EDGES; ++e) b[edge_bernstein[e]] = integer_shifted(w, b[edge_bernstein[e]], 1);
  integer_keep(w, mark, b, HL_BERNSTEIN);
  jacdet->exponent = exponent_of(&points);
}

integer exact_cube_centre(workspace *w, const exact_jacdet *jacdet) {
  return integer_difference(w, sum_of(w, jacdet->bernstein, edge_bernstein, HL_EDGES),
                            sum_of(w, jacdet->bernstein, vertex_bernstein, HL_VERTICES));
}

void exact_middle_columns(workspace *w, const double vertices[24], scaled_double columns[3][3]) {
  const size_t mark = w->used;
  integer_points points;
  integer_coordinates(w, vertices, ALL_VERTICES, &points);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) {
      integer sum = zero; /* of the four edges along axis c */
      for (int v = 0; v < HL_VERTICES; ++v)
        sum = integer_sum(w, sum, vertex_reference[v][c] ? points.p[v][r] : integer_negated(points.p[v][r]));
      columns[c][r] = rounded_integer(w, sum, points.exponents[r] - 2);
    }
  w->used = mark;
}

scaled_double exact_volume(workspace *w, const double vertices[24]) {
  const size_t mark = w->used;
  integer_points points;
  integer_coordinates(w, vertices, ALL_VERTICES, &points);
  integer total = zero;
  for (int d = 0; d < 3; ++d) {
    integer columns[3][3], normal[3];
    for (int c = 0; c < 3; ++c) {
      const unsigned char (*pairs)[2] = volume_columns[d][c];
      difference(w, &points, pairs[0][1], pairs[0][0], columns[c]);
      if (pairs[1][0] == pairs[1][1]) continue;
      integer second[3];
      difference(w, &points, pairs[1][1], pairs[1][0], second);
      for (int r = 0; r < 3; ++r) columns[c][r] = integer_sum(w, columns[c][r], second[r]);
    }
    cross_product(w, columns[0], columns[1], normal);
    total = integer_sum(w, total, dot_product(w, normal, columns[2]));
  }
  const scaled_double volume = rounded_quotient(w, total, integer_of(w, 12), exponent_of(&points));
  w->used = mark;
  return volume;
}
