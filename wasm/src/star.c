/* The frame of a star and its affine Bernstein coefficients: docs/repair.md (R1) to (R4). */
#include "star.h"
#include "bernstein.h"
#include "scaling.h"
#include "topology.h"

#include <string.h>

size_t star_cell_count(const hl_star *star) {
  return star->cells.indices ? star->cells.index_count / HL_VERTICES : star->cells.coordinate_count / HL_COORDINATES;
}

static const double *point_of(const hl_star *star, size_t cell, int v) {
  const hl_cells *cells = &star->cells;
  const size_t at = HL_VERTICES * cell + (size_t)v;
  return cells->coordinates + 3 * (cells->indices ? cells->indices[at] : at);
}

static unsigned moving_vertices(const hl_star *star, size_t cell) {
  if (star->moving) return star->moving[cell];
  unsigned bits = 0;
  for (int v = 0; v < HL_VERTICES; ++v)
    bits |= (unsigned)(star->cells.indices[HL_VERTICES * cell + (size_t)v] == star->vertex) << v;
  return bits;
}

static hl_status check_star(const hl_star *star, const double **present) {
  const hl_cells *cells = &star->cells;
  const size_t length = cells->indices ? cells->index_count : cells->coordinate_count;
  if (length % (cells->indices ? HL_VERTICES : HL_COORDINATES) != 0 || cells->coordinate_count % 3 != 0)
    return HL_INCOMPLETE;
  if (length == 0 || (!cells->indices && !star->moving)) return HL_MISSING_LIST;
  for (size_t i = 0; i < cells->index_count && cells->indices; ++i)
    if (cells->indices[i] >= cells->coordinate_count / 3) return HL_NO_SUCH_POINT;
  *present = NULL;
  for (size_t c = 0; c < star_cell_count(star); ++c) {
    const unsigned moving = moving_vertices(star, c);
    if (moving == 0) return HL_NOTHING_MOVES;
    for (int v = 0; v < HL_VERTICES; ++v) {
      const double *p = point_of(star, c, v);
      if (!all_finite(p, 3)) return HL_NOT_FINITE;
      if (!(moving >> v & 1)) continue;
      if (!*present) *present = p;
      for (int r = 0; r < 3; ++r)
        if (p[r] != (*present)[r]) return HL_SEVERAL_PLACES;
    }
  }
  return HL_OK;
}

void placed_cell(const hl_star *star, size_t cell, const double place[3], double vertices[24]) {
  const unsigned moving = moving_vertices(star, cell);
  for (int v = 0; v < HL_VERTICES; ++v)
    memcpy(vertices + 3 * v, moving >> v & 1 ? place : point_of(star, cell, v), 3 * sizeof *vertices);
}

void turned_cell(const star_frame *frame, double vertices[24]) {
  for (int v = 0; v < HL_VERTICES; ++v) {
    const double p[3] = {vertices[3 * v], vertices[3 * v + 1], vertices[3 * v + 2]};
    for (int a = 0; a < 3; ++a) vertices[3 * v + a] = frame->sign[a] * p[frame->axis[a]];
  }
}

void place_of(const star_frame *frame, const double z[3], double place[3]) {
  for (int a = 0; a < 3; ++a) {
    const int r = frame->axis[a];
    place[r] = frame->origin[r];
    if (z[a] != 0) place[r] += frame->sign[a] * times_power_of_two(z[a], frame->exponent);
    if (frame->limits) place[r] = smaller(larger(place[r], frame->limits->low[r]), frame->limits->high[r]);
  }
}

/* Differences from the present place, halved twice where they could overflow: then times 2^-2. */
static double offset_of(double x, double origin, bool is_huge) {
  return is_huge ? 0.25 * x - 0.25 * origin : x - origin;
}

static bool is_huge_star(const hl_star *star, size_t count) {
  double extent = 0;
  for (size_t c = 0; c < count; ++c)
    for (int v = 0; v < HL_VERTICES; ++v) extent = larger(extent, greatest_magnitude(point_of(star, c, v), 3));
  return extent >= 0x1p1021;
}

/* The finalizer of splitmix64. */
static uint64_t mixed(uint64_t x) {
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}

static uint64_t key_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return mixed(bits + 0x9e3779b97f4a7c15u);
}

/* Offsets in units of the greatest, which is in [1/2, 1). */
static double unit_offset(const hl_star *star, const star_frame *frame, bool is_huge, size_t cell, int v, int r) {
  const double offset = offset_of(point_of(star, cell, v)[r], frame->origin[r], is_huge);
  return offset == 0 ? 0 : times_power_of_two(offset, (is_huge ? 2 : 0) - frame->exponent);
}

/* Axes by rising keys, the greater sum of keys to the positive side: the sums depend on no order and on no turn. Then the rotation
   among the frame and its mirror image in a point. */
static void choose_axes(const hl_star *star, size_t count, bool is_huge, star_frame *frame) {
  uint64_t sums[3][2] = {{0, 0}, {0, 0}, {0, 0}};
  for (size_t c = 0; c < count; ++c)
    for (int v = 0; v < HL_VERTICES; ++v)
      for (int r = 0; r < 3; ++r) {
        const double x = unit_offset(star, frame, is_huge, c, v, r);
        if (x != 0) sums[r][x < 0] += key_of(fabs(x));
      }
  bool is_odd = false;
  for (int a = 0; a < 3; ++a) frame->axis[a] = a;
  for (int n = 0; n < 3; ++n) {
    const int a = n % 2, low = frame->axis[a], high = frame->axis[a + 1];
    if (sums[high][0] + sums[high][1] >= sums[low][0] + sums[low][1]) continue;
    frame->axis[a] = high;
    frame->axis[a + 1] = low;
    is_odd = !is_odd;
  }
  for (int a = 0; a < 3; ++a) {
    const uint64_t *sum = sums[frame->axis[a]];
    frame->sign[a] = sum[1] > sum[0] ? -1 : 1;
    if (sum[1] > sum[0]) is_odd = !is_odd;
  }
  for (int a = 0; a < 3; ++a) frame->sign[a] = is_odd ? -frame->sign[a] : frame->sign[a];
}

static void find_frame(const hl_star *star, const double present[3], size_t count, star_frame *frame, bool *is_huge) {
  memcpy(frame->origin, present, sizeof frame->origin);
  *is_huge = is_huge_star(star, count);
  double extent = 0;
  for (size_t c = 0; c < count; ++c)
    for (int v = 0; v < HL_VERTICES; ++v)
      for (int r = 0; r < 3; ++r)
        extent = larger(extent, fabs(offset_of(point_of(star, c, v)[r], present[r], *is_huge)));
  frame->exponent = extent > 0 ? binary_exponent(extent) + (*is_huge ? 2 : 0) : 0;
  choose_axes(star, count, *is_huge, frame);
}

/* (R14) in the units of the frame. */
#define BOX 0x1p20

/* A limit of a coordinate in the frame, at most so far as the box. */
static double limit_of(const star_frame *frame, bool is_huge, double limit, int r) {
  const double offset = offset_of(limit, frame->origin[r], is_huge);
  if (offset == 0) return 0;
  if (!(fabs(offset) <= 0x1.fffffffffffffp1023)) return offset > 0 ? BOX : -BOX;
  const double z = times_power_of_two(offset, (is_huge ? 2 : 0) - frame->exponent);
  return smaller(larger(z, -BOX), BOX);
}

/* (R13): the part of a normal of length 1 that is no longer told from a multiple of another. */
#define PARALLEL 0x1p-32

/* Takes the normals into the frame's axes and makes them orthonormal. */
static bool read_normals(const hl_limits *limits, star_frame *frame) {
  for (int i = 0; i < 2; ++i) {
    const double *given = limits->normals[i], size = greatest_magnitude(given, 3);
    if (size == 0) continue;
    double n[3];
    for (int a = 0; a < 3; ++a) n[a] = frame->sign[a] * (given[frame->axis[a]] / size);
    double length = sqrt(dot(n, n));
    for (int a = 0; a < 3; ++a) n[a] /= length;
    for (int pass = 0; pass < 2; ++pass) project(frame, n);
    length = sqrt(dot(n, n));
    if (!(length > PARALLEL)) return false;
    for (int a = 0; a < 3; ++a) frame->normals[frame->normal_count][a] = n[a] / length;
    ++frame->normal_count;
  }
  return true;
}

static hl_status read_limits(const hl_star *star, bool is_huge, star_frame *frame) {
  const hl_limits *limits = star->limits;
  frame->limits = limits;
  frame->normal_count = 0;
  for (int a = 0; a < 3; ++a) {
    const int r = frame->axis[a];
    frame->low[a] = -BOX;
    frame->high[a] = BOX;
    if (!limits) continue;
    if (!(limits->low[r] <= frame->origin[r] && frame->origin[r] <= limits->high[r])) return HL_OUTSIDE_LIMITS;
    const double low = limit_of(frame, is_huge, limits->low[r], r), high = limit_of(frame, is_huge, limits->high[r], r);
    frame->low[a] = frame->sign[a] > 0 ? low : -high;
    frame->high[a] = frame->sign[a] > 0 ? high : -low;
  }
  return limits && !read_normals(limits, frame) ? HL_OUTSIDE_LIMITS : HL_OK;
}

void project(const star_frame *frame, double gradient[3]) {
  for (int i = 0; i < frame->normal_count; ++i) {
    const double along = dot(gradient, frame->normals[i]);
    for (int a = 0; a < 3; ++a) gradient[a] -= along * frame->normals[i][a];
  }
}

/* Columns of a determinant: u + alpha z, v + beta z, w + gamma z. The terms with two of the three z vanish, (R1). */
typedef struct columns {
  const double *u, *v, *w;
  double alpha, beta, gamma;
} columns;

static void add_cross(double factor, const double a[3], const double b[3], affine *sum) {
  if (factor == 0) return;
  double n[3];
  cross(a, b, n);
  for (int r = 0; r < 3; ++r) sum->gradient[r] += factor * n[r];
}

static void add_determinant(columns m, affine *sum) {
  double n[3];
  cross(m.v, m.w, n);
  sum->constant += dot(m.u, n);
  for (int r = 0; r < 3 && m.alpha != 0; ++r) sum->gradient[r] += m.alpha * n[r];
  add_cross(m.beta, m.w, m.u, sum);
  add_cross(m.gamma, m.u, m.v, sum);
}

static void add(double factor, const affine *f, affine *sum) {
  for (int r = 0; r < 3; ++r) sum->gradient[r] += factor * f->gradient[r];
  sum->constant += factor * f->constant;
}

/* The twelve edge vectors of a cell, [i][j] by the two other reference coordinates, and the multiple of z that each has. */
typedef struct moving_edges {
  double u[2][2][3], v[2][2][3], w[2][2][3];
  double alpha[2][2], beta[2][2], gamma[2][2];
} moving_edges;

static void find_edges(const double p[8][3], unsigned moving, moving_edges *e) {
  for (int m = 0; m < 2; ++m)
    for (int n = 0; n < 2; ++n) {
      const int u0 = vertex_at[0][m][n], u1 = vertex_at[1][m][n], v0 = vertex_at[m][0][n], v1 = vertex_at[m][1][n],
                w0 = vertex_at[m][n][0], w1 = vertex_at[m][n][1];
      for (int r = 0; r < 3; ++r) {
        e->u[m][n][r] = p[u1][r] - p[u0][r];
        e->v[m][n][r] = p[v1][r] - p[v0][r];
        e->w[m][n][r] = p[w1][r] - p[w0][r];
      }
      e->alpha[m][n] = (int)(moving >> u1 & 1) - (int)(moving >> u0 & 1);
      e->beta[m][n] = (int)(moving >> v1 & 1) - (int)(moving >> v0 & 1);
      e->gamma[m][n] = (int)(moving >> w1 & 1) - (int)(moving >> w0 & 1);
    }
}

/* U_jk, V_ik and W_mn of docs/algorithm.md (3) to (6). */
static columns columns_of(const moving_edges *e, const int u[2], const int v[2], const int w[2]) {
  return (columns){.u = e->u[u[0]][u[1]],
                   .v = e->v[v[0]][v[1]],
                   .w = e->w[w[0]][w[1]],
                   .alpha = e->alpha[u[0]][u[1]],
                   .beta = e->beta[v[0]][v[1]],
                   .gamma = e->gamma[w[0]][w[1]]};
}

static void find_bernstein(const moving_edges *e, affine b[27]) {
  memset(b, 0, HL_BERNSTEIN * sizeof *b);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k)
        add_determinant(columns_of(e, (int[]){j, k}, (int[]){i, k}, (int[]){i, j}),
                        &b[bernstein_index(2 * i, 2 * j, 2 * k)]);
  for (int m = 0; m < 2; ++m)
    for (int n = 0; n < 2; ++n)
      for (int near = 0; near < 2; ++near) {
        const int far = 1 - near;
        add_determinant(columns_of(e, (int[]){m, n}, (int[]){near, n}, (int[]){far, m}),
                        &b[bernstein_index(1, 2 * m, 2 * n)]);
        add_determinant(columns_of(e, (int[]){near, n}, (int[]){m, n}, (int[]){m, far}),
                        &b[bernstein_index(2 * m, 1, 2 * n)]);
        add_determinant(columns_of(e, (int[]){n, near}, (int[]){m, far}, (int[]){m, n}),
                        &b[bernstein_index(2 * m, 2 * n, 1)]);
      }
  for (int edge = 0; edge < HL_EDGES; ++edge) {
    affine *middle = &b[edge_bernstein[edge]];
    for (int r = 0; r < 3; ++r) middle->gradient[r] *= 0.5;
    middle->constant *= 0.5;
  }
  for (int face = 0; face < HL_FACES; ++face) {
    const unsigned char *on = face_coefficients[face];
    for (int i = 1; i < 9; i += 2) add(0.5, &b[on[i]], &b[on[4]]);
    for (int i = 0; i < 9; i += i == 2 ? 4 : 2) add(-0.25, &b[on[i]], &b[on[4]]);
  }
}

/* (R4): the cube of the root mean square of the edges that do not move. */
static double scale_of(const double p[8][3], unsigned moving) {
  double sum = 0;
  int count = 0;
  for (int edge = 0; edge < HL_EDGES; ++edge) {
    const int from = edge_ends[edge][0], to = edge_ends[edge][1];
    if ((moving >> from | moving >> to) & 1) continue;
    for (int r = 0; r < 3; ++r) sum += (p[to][r] - p[from][r]) * (p[to][r] - p[from][r]);
    ++count;
  }
  const double length = count > 0 ? sqrt(sum / count) : 0, scale = length * length * length;
  return scale > 0 ? scale : 1;
}

/* (R13): the part of a gradient that the normals leave of it, but for rounding. */
#define GRADIENT_ERROR 0x1p-44

static void project_all(const star_frame *frame, affine b[27]) {
  for (int i = 0; i < HL_BERNSTEIN && frame->normal_count > 0; ++i) {
    double *gradient = b[i].gradient;
    const double before = greatest_magnitude(gradient, 3);
    project(frame, gradient);
    if (greatest_magnitude(gradient, 3) <= GRADIENT_ERROR * before) memset(gradient, 0, 3 * sizeof *gradient);
  }
}

static void fill_cell(const star_frame *frame, const double p[8][3], unsigned moving, uint32_t number,
                      star_cell *cell) {
  moving_edges edges;
  find_edges(p, moving, &edges);
  find_bernstein(&edges, cell->bernstein);
  project_all(frame, cell->bernstein);
  memset(&cell->volume, 0, sizeof cell->volume);
  for (int edge = 0; edge < HL_EDGES; ++edge) add(1. / HL_EDGES, &cell->bernstein[edge_bernstein[edge]], &cell->volume);
  cell->scale = scale_of(p, moving);
  cell->number = number;
  cell->key = moving;
  for (int i = 0; i < HL_COORDINATES; ++i) cell->key = mixed(cell->key ^ key_of(p[i / 3][i % 3]));
}

/* A cell's offsets in the frame; a zero is positive, so that keys do not tell -0 from it. */
static void frame_points(const hl_star *star, const star_frame *frame, bool is_huge, size_t cell, double p[8][3]) {
  for (int v = 0; v < HL_VERTICES; ++v)
    for (int a = 0; a < 3; ++a)
      p[v][a] = frame->sign[a] * unit_offset(star, frame, is_huge, cell, v, frame->axis[a]) + 0.0;
}

hl_status read_star(const hl_star *star, star_frame *frame, star_cell *cells) {
  const double *present;
  const hl_status status = check_star(star, &present);
  if (status != HL_OK) return status;
  const size_t count = star_cell_count(star);
  bool is_huge;
  find_frame(star, present, count, frame, &is_huge);
  const hl_status limited = read_limits(star, is_huge, frame);
  if (limited != HL_OK) return limited;
  for (size_t c = 0; c < count; ++c) {
    double p[8][3];
    star_cell cell;
    frame_points(star, frame, is_huge, c, p);
    fill_cell(frame, (const double (*)[3])p, moving_vertices(star, c), (uint32_t)c, &cell);
    size_t at = c;
    for (; at > 0 && cells[at - 1].key > cell.key; --at) cells[at] = cells[at - 1];
    cells[at] = cell;
  }
  return HL_OK;
}
