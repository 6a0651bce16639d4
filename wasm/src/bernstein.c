/* The 27 Bernstein coefficients of jacdet from the edge vectors: docs/algorithm.md (3) to (8). */
#include "bernstein.h"
#include "topology.h"

/* Corners, and twice the middles of edges. Corners and the middles of xi- and eta-edges share the crosses U_jk x V_ik; the middles
   of zeta-edges need U_j0 x V_i1 + U_j1 x V_i0. */
static void corners_and_edges(const edge_vectors *e, double bernstein[27]) {
  double to_far_v[2][2][2]; /* [i][j][k]: (U_jk x V_ik) . W_1-i,j, half of an xi-edge's middle */
  double to_far_u[2][2][2]; /* [i][j][k]: (U_jk x V_ik) . W_i,1-j, half of an eta-edge's middle */
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) {
        double n[3];
        cross(e->u[j][k], e->v[i][k], n);
        bernstein[bernstein_index(2 * i, 2 * j, 2 * k)] = dot(n, e->w[i][j]);
        to_far_v[i][j][k] = dot(n, e->w[1 - i][j]);
        to_far_u[i][j][k] = dot(n, e->w[i][1 - j]);
      }
  for (int m = 0; m < 2; ++m)
    for (int k = 0; k < 2; ++k) {
      bernstein[bernstein_index(1, 2 * m, 2 * k)] = to_far_v[0][m][k] + to_far_v[1][m][k];
      bernstein[bernstein_index(2 * m, 1, 2 * k)] = to_far_u[m][0][k] + to_far_u[m][1][k];
    }
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      double n[3], other[3];
      cross(e->u[j][0], e->v[i][1], n);
      cross(e->u[j][1], e->v[i][0], other);
      for (int r = 0; r < 3; ++r) n[r] += other[r];
      bernstein[bernstein_index(2 * i, 2 * j, 1)] = dot(n, e->w[i][j]);
    }
}

/* s^2 t^2 does not occur in f, so a face's middle, four times it here, follows from its edges and corners, and the cube's alike. */
static void face_centres(double b[27]) {
  for (int face = 0; face < 6; ++face) {
    int s = axis_stride[face_table[face].s], t = axis_stride[face_table[face].t];
    double *c = b + face_middle(face);
    double middles = (c[-s] + c[s]) + (c[-t] + c[t]);
    double corners = (c[-s - t] + c[s + t]) + (c[-s + t] + c[s - t]);
    *c = middles - corners;
  }
}

static void cube_centre(double b[27]) {
  double middles = 0, corners = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) {
        int ones = (i == 1) + (j == 1) + (k == 1);
        if (ones == 0) corners += b[bernstein_index(i, j, k)];
        if (ones == 1) middles += b[bernstein_index(i, j, k)];
      }
  b[CUBE_CENTRE] = 0.25 * (middles - corners) + 0.0;
}

void jacdet_bernstein(const edge_vectors *edges, double bernstein[27]) {
  corners_and_edges(edges, bernstein);
  face_centres(bernstein);
  bernstein[CUBE_CENTRE] = 0;
  for (int i = 0; i < 27; ++i) bernstein[i] = bernstein_factor[i] * bernstein[i] + 0.0; /* -0 becomes 0 */
  cube_centre(bernstein);
}

/* A cross product with plus signs. */
static void permanent_cross(const double a[3], const double b[3], double out[3]) {
  out[0] = a[1] * b[2] + a[2] * b[1];
  out[1] = a[2] * b[0] + a[0] * b[2];
  out[2] = a[0] * b[1] + a[1] * b[0];
}

static void magnitudes_of(const double family[2][2][3], double magnitudes[2][2][3]) {
  for (int i = 0; i < 12; ++i) magnitudes[i / 6][i / 3 % 2][i % 3] = fabs(family[i / 6][i / 3 % 2][i % 3]);
}

double greatest_permanent(const edge_vectors *edges) {
  double u[2][2][3], v[2][2][3], w[2][2][3];
  magnitudes_of(edges->u, u);
  magnitudes_of(edges->v, v);
  magnitudes_of(edges->w, w);
  double greatest = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) {
        double n[3];
        permanent_cross(u[j][k], v[i][k], n);
        greatest = larger(greatest, dot(n, w[i][j]));
        greatest = larger(greatest, dot(n, w[1 - i][j]));
        greatest = larger(greatest, dot(n, w[i][1 - j]));
        permanent_cross(u[j][k], v[i][1 - k], n);
        greatest = larger(greatest, dot(n, w[i][j]));
      }
  return greatest;
}

void face_bernstein(const double bernstein[27], int face, double beta[9]) {
  for (int i = 0; i < 9; ++i) beta[i] = bernstein[face_coefficients[face][i]];
}
