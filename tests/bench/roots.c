/* Twenty determinants at corners and edge middles; quadratics on the edges, f = sum D_ij s^i t^j with eight coefficients on the
   faces, the quartic P by the paper's expansion, its roots by Algorithm 1010. No concavity screening. */
#include "roots.h"
#include "quartic.h"

#include <stddef.h>

typedef struct edges {
  double u[2][2][3], v[2][2][3], w[2][2][3]; /* u[j][k], v[i][k], w[i][j] */
} edges;

static void edge_vectors(const double p[24], edges *e) {
  static const unsigned char at[2][2][2] = {{{0, 4}, {3, 7}}, {{1, 5}, {2, 6}}};
  for (int m = 0; m < 2; ++m)
    for (int n = 0; n < 2; ++n)
      for (int r = 0; r < 3; ++r) {
        e->u[m][n][r] = p[3 * at[1][m][n] + r] - p[3 * at[0][m][n] + r];
        e->v[m][n][r] = p[3 * at[m][1][n] + r] - p[3 * at[m][0][n] + r];
        e->w[m][n][r] = p[3 * at[m][n][1] + r] - p[3 * at[m][n][0] + r];
      }
}

static inline double determinant(const double a[3], const double b[3], const double c[3]) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

static inline void middle(const double a[3], const double b[3], double out[3]) {
  for (int r = 0; r < 3; ++r) out[r] = 0.5 * (a[r] + b[r]);
}

/* jacdet at the 20 of the 27 points {0, 1/2, 1}^3, [9i + 3j + k], that are corners and edge middles. */
static inline double corner(const edges *e, int i, int j, int k) {
  return determinant(e->u[j][k], e->v[i][k], e->w[i][j]);
}

static inline double edge_middle(const edges *e, int axis, int m, int n) {
  double a[3], b[3];
  if (axis == 0) {
    middle(e->v[0][n], e->v[1][n], a);
    middle(e->w[0][m], e->w[1][m], b);
    return determinant(e->u[m][n], a, b);
  }
  if (axis == 1) {
    middle(e->u[0][n], e->u[1][n], a);
    middle(e->w[m][0], e->w[m][1], b);
    return determinant(a, e->v[m][n], b);
  }
  middle(e->u[n][0], e->u[n][1], a);
  middle(e->v[m][0], e->v[m][1], b);
  return determinant(a, b, e->w[m][n]);
}

static const int strides[3] = {9, 3, 1};

/* The first of an edge's three samples. */
static inline int start_of(int axis, int m, int n) {
  return axis == 0 ? 6 * m + 2 * n : axis == 1 ? 18 * m + 2 * n : 18 * m + 6 * n;
}

/* The state of one query: the least value so far, and where. */
typedef struct search {
  double least, place[3];
} search;

static inline void take(search *found, double value, double x, double y, double z) {
  if (!(value < found->least)) return;
  *found = (search){value, {x, y, z}};
}

/* The quadratic through an edge's three samples; takes its vertex. */
static inline void search_edge(const double samples[27], int axis, int m, int n, search *found) {
  const double *q = samples + start_of(axis, m, n);
  double q0 = q[0], qm = q[strides[axis]], q1 = q[2 * strides[axis]];
  double d2 = 2 * (q0 + q1) - 4 * qm, d1 = 4 * qm - 3 * q0 - q1;
  if (!(d2 > 0)) return;
  double r = -d1 / (2 * d2);
  if (!(r > 0 && r < 1)) return;
  double value = (d2 * r + d1) * r + q0;
  take(found, value, axis == 0 ? r : m, axis == 1 ? r : axis == 0 ? m : n, axis == 2 ? r : n);
}

/* Coefficients of f(s,t) = a(t) s^2 + b(t) s + c(t) from a face's eight samples. */
typedef struct face {
  double a0, a1, b0, b1, b2, c0, c1, c2;
} face;

static inline face face_of(const double *f, int s, int t) {
  double f00 = f[0], fm0 = f[s], f10 = f[2 * s], f01 = f[2 * t], fm1 = f[s + 2 * t], f11 = f[2 * s + 2 * t], f0m = f[t],
         f1m = f[2 * s + t];
  face out;
  out.c0 = f00;
  out.c1 = 4 * f0m - 3 * f00 - f01;
  out.c2 = 2 * (f00 + f01) - 4 * f0m;
  out.a0 = 2 * (f00 + f10) - 4 * fm0;
  out.a1 = 2 * (f01 + f11) - 4 * fm1 - out.a0;
  out.b0 = 4 * fm0 - 3 * f00 - f10;
  double b_at_1 = 4 * fm1 - 3 * f01 - f11, b_at_middle = f1m - f0m - (out.a0 + 0.5 * out.a1);
  out.b1 = 4 * b_at_middle - 3 * out.b0 - b_at_1;
  out.b2 = 2 * (out.b0 + b_at_1) - 4 * b_at_middle;
  return out;
}

/* The least of a face's nine Bernstein coefficients, given the eight on its edges, [3 s + t] in strides. */
static inline double lower_bound(const double *beta, int s, int t) {
  double middles = (beta[s] + beta[s + 2 * t]) + (beta[t] + beta[2 * s + t]);
  double corners = (beta[0] + beta[2 * s]) + (beta[2 * t] + beta[2 * s + 2 * t]);
  double least = 0.5 * middles - 0.25 * corners;
  const double others[8] = {beta[0],     beta[s],         beta[2 * s],     beta[t],
                            beta[2 * s + t], beta[2 * t], beta[s + 2 * t], beta[2 * s + 2 * t]};
  for (int i = 0; i < 8; ++i) least = others[i] < least ? others[i] : least;
  return least;
}

static void search_face(const face *f, int axis, int side, search *found, bool stop_at_zero) {
  const double a0 = f->a0, a1 = f->a1, b0 = f->b0, b1 = f->b1, b2 = f->b2, c1 = f->c1, c2 = f->c2;
  const double p[5] = {a1 * b0 * b0 - 2 * a0 * b0 * b1 + 4 * a0 * a0 * c1,
                       8 * a0 * a0 * c2 + 8 * a0 * a1 * c1 - 4 * a0 * b0 * b2 - 2 * a0 * b1 * b1,
                       16 * a0 * a1 * c2 - 6 * a0 * b1 * b2 + 4 * a1 * a1 * c1 - 2 * a1 * b0 * b2 - a1 * b1 * b1,
                       8 * a1 * a1 * c2 - 4 * a0 * b2 * b2 - 4 * a1 * b1 * b2, -3 * a1 * b2 * b2};
  double roots[4];
  int count = real_roots(p, roots);
  for (int r = 0; r < count; ++r) {
    double t = roots[r];
    if (!(t > 0 && t < 1)) continue;
    double a = a0 + a1 * t, b = b0 + (b1 + b2 * t) * t;
    if (!(a > 0)) continue;
    double s = -b / (2 * a);
    if (!(s > 0 && s < 1)) continue;
    double value = (a * s + b) * s + f->c0 + (c1 + c2 * t) * t;
    take(found, value, axis == 0 ? side : s, axis == 0 ? s : axis == 1 ? side : t, axis == 2 ? side : t);
    if (stop_at_zero && value <= 0) return;
  }
}

/* The Bernstein coefficients of the corners and edges from their samples. */
static inline void edge_coefficients(const double samples[27], double beta[27]) {
  for (int axis = 0; axis < 3; ++axis)
    for (int m = 0; m < 2; ++m)
      for (int n = 0; n < 2; ++n) {
        int from = start_of(axis, m, n), step = strides[axis];
        beta[from] = samples[from];
        beta[from + 2 * step] = samples[from + 2 * step];
        beta[from + step] = 2 * samples[from + step] - 0.5 * (samples[from] + samples[from + 2 * step]);
      }
}

/* Face by face; `stop_at_zero` for a validity query. */
static inline void search_faces(const double samples[27], bool with_bounds, bool stop_at_zero, search *found) {
  double beta[27];
  if (with_bounds) edge_coefficients(samples, beta);
  for (int axis = 0; axis < 3; ++axis) {
    int s = axis == 0 ? 3 : 9, t = axis == 2 ? 3 : 1;
    for (int side = 0; side < 2; ++side) {
      int from = 2 * side * strides[axis];
      if (with_bounds) {
        double bound = lower_bound(beta + from, s, t);
        if (stop_at_zero ? bound > 0 : bound >= found->least) continue;
      }
      face f = face_of(samples + from, s, t);
      search_face(&f, axis, side, found, stop_at_zero);
      if (stop_at_zero && found->least <= 0) return;
    }
  }
}

bool roots_validity(const double vertices[24], bool with_bounds) {
  edges e;
  double samples[27];
  edge_vectors(vertices, &e);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) {
        double value = corner(&e, i, j, k);
        if (value <= 0) return false;
        samples[18 * i + 6 * j + 2 * k] = value;
      }
  search found = {.least = 1e300};
  for (int axis = 0; axis < 3; ++axis)
    for (int m = 0; m < 2; ++m)
      for (int n = 0; n < 2; ++n) {
        samples[start_of(axis, m, n) + strides[axis]] = edge_middle(&e, axis, m, n);
        search_edge(samples, axis, m, n, &found);
        if (found.least <= 0) return false;
      }
  search_faces(samples, with_bounds, true, &found);
  return found.least > 0;
}

double roots_minimum(const double vertices[24], bool with_bounds, double minimizer[3]) {
  edges e;
  double samples[27];
  search found = {.least = 1e300};
  edge_vectors(vertices, &e);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) {
        double value = samples[18 * i + 6 * j + 2 * k] = corner(&e, i, j, k);
        take(&found, value, i, j, k);
      }
  for (int axis = 0; axis < 3; ++axis)
    for (int m = 0; m < 2; ++m)
      for (int n = 0; n < 2; ++n) {
        samples[start_of(axis, m, n) + strides[axis]] = edge_middle(&e, axis, m, n);
        search_edge(samples, axis, m, n, &found);
      }
  search_faces(samples, with_bounds, false, &found);
  for (int r = 0; r < 3; ++r) minimizer[r] = found.place[r];
  return found.least;
}

double twenty_determinants(const double vertices[24]) {
  edges e;
  edge_vectors(vertices, &e);
  double sum = 0;
  for (int m = 0; m < 2; ++m)
    for (int n = 0; n < 2; ++n) {
      sum += corner(&e, 0, m, n) + corner(&e, 1, m, n);
      for (int axis = 0; axis < 3; ++axis) sum += edge_middle(&e, axis, m, n);
    }
  return sum;
}
