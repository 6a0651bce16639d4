/* The fast stage for one instruction set: a file names it in LANES and includes this. Bounds: docs/algorithm.md 10. */
#include "error_bounds.h"
#include "hexlens.h"
#include "lanes.h"
#include "lanes_vector.h"
#include "topology.h"

typedef struct float_edges {
  floats u[2][2][3], v[2][2][3], w[2][2][3];
} float_edges;

typedef struct double_edges {
  doubles u[2][2][3], v[2][2][3], w[2][2][3];
} double_edges;

#define CROSS(a, b, out)                                                                                               \
  ((out)[0] = (a)[1] * (b)[2] - (a)[2] * (b)[1], (out)[1] = (a)[2] * (b)[0] - (a)[0] * (b)[2],                         \
   (out)[2] = (a)[0] * (b)[1] - (a)[1] * (b)[0])
#define DOT(a, b) ((a)[0] * (b)[0] + (a)[1] * (b)[1] + (a)[2] * (b)[2])

/* The edges' components on one axis, from p[v][axis]. */
#define SUBTRACT_VERTICES(p, e, axis)                                                                                  \
  for (int m = 0; m < 2; ++m)                                                                                          \
    for (int n = 0; n < 2; ++n) {                                                                                      \
      (e)->u[m][n][axis] = (p)[3 * vertex_at[1][m][n] + axis] - (p)[3 * vertex_at[0][m][n] + axis];                    \
      (e)->v[m][n][axis] = (p)[3 * vertex_at[m][1][n] + axis] - (p)[3 * vertex_at[m][0][n] + axis];                    \
      (e)->w[m][n][axis] = (p)[3 * vertex_at[m][n][1] + axis] - (p)[3 * vertex_at[m][n][0] + axis];                    \
    }

/* Eight bits as eight bytes of 0 or 1, the lowest first in memory: all machines with these vectors are little-endian. */
static inline uint64_t bytes_of(unsigned bits) {
  uint64_t own_bit = ((bits & 0xff) * 0x0101010101010101u) & 0x8040201008040201u;
  return (own_bit + 0x7f7f7f7f7f7f7f7fu) >> 7 & 0x0101010101010101u;
}

static inline void decide_group(const double *hexahedra, unsigned char *verdicts) {
  floats p[24];
  load_relative(hexahedra, p);
  floats extent[3];
  for (int axis = 0; axis < 3; ++axis) {
    extent[axis] = magnitude_of_floats(p[3 + axis]);
    for (int v = 2; v < 8; ++v) extent[axis] = larger_floats(extent[axis], magnitude_of_floats(p[3 * v + axis]));
  }
  float_bits usable = (extent[0] >= LEAST_FLOAT) & (extent[0] <= GREATEST_FLOAT) & (extent[1] >= LEAST_FLOAT) &
                      (extent[1] <= GREATEST_FLOAT) & (extent[2] >= LEAST_FLOAT) & (extent[2] <= GREATEST_FLOAT);
  floats error = FLOAT_ERROR * (extent[0] * extent[1] * extent[2]);

  float_edges e;
  for (int axis = 0; axis < 3; ++axis) SUBTRACT_VERTICES(p, &e, axis)
  floats normal[2][2][2][3], corner[2][2][2], least = {0}, sum = {0};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) {
        CROSS(e.u[j][k], e.v[i][k], normal[i][j][k]);
        corner[i][j][k] = DOT(normal[i][j][k], e.w[i][j]);
        least = i + j + k == 0 ? corner[i][j][k] : smaller_floats(least, corner[i][j][k]);
        sum += corner[i][j][k];
      }
  usable &= sum == sum; /* a coordinate that is not finite makes the corner NaN */
  unsigned invalid = float_lane_bits((least < -error) & usable), valid = 0;
  if (invalid != (1u << FLOATS) - 1) {
    floats x[2][2], y[2][2],
        z[2][2]; /* twice the middles of the edges along xi at [j][k], eta at [i][k], zeta at [i][j] */
    for (int m = 0; m < 2; ++m)
      for (int n = 0; n < 2; ++n) {
        x[m][n] = DOT(normal[0][m][n], e.w[1][m]) + DOT(normal[1][m][n], e.w[0][m]);
        y[m][n] = DOT(normal[m][0][n], e.w[m][1]) + DOT(normal[m][1][n], e.w[m][0]);
        floats a[3], b[3];
        CROSS(e.u[n][0], e.v[m][1], a);
        CROSS(e.u[n][1], e.v[m][0], b);
        for (int r = 0; r < 3; ++r) a[r] += b[r];
        z[m][n] = DOT(a, e.w[m][n]);
      }
    /* Four times the values in the middles of the edges, eight times those in the middles of the faces, (L3). */
    floats middles = x[0][0], centres = all_floats(0), edges = all_floats(0), faces = all_floats(0);
    for (int m = 0; m < 2; ++m)
      for (int n = 0; n < 2; ++n) {
        middles = smaller_floats(smaller_floats(middles, x[m][n]), smaller_floats(y[m][n], z[m][n]));
        edges = smaller_floats(edges, x[m][n] + (corner[0][m][n] + corner[1][m][n]));
        edges = smaller_floats(edges, y[m][n] + (corner[m][0][n] + corner[m][1][n]));
        edges = smaller_floats(edges, z[m][n] + (corner[m][n][0] + corner[m][n][1]));
      }
    for (int m = 0; m < 2; ++m) {
      /* The faces xi, eta, zeta = m: twice the edges' middles, less the corners: 4 times the
         centre. */
      floats xi = (y[m][0] + y[m][1]) + (z[m][0] + z[m][1]), eta = (x[m][0] + x[m][1]) + (z[0][m] + z[1][m]),
             zeta = (x[0][m] + x[1][m]) + (y[0][m] + y[1][m]);
      faces = smaller_floats(smaller_floats(faces, xi), smaller_floats(eta, zeta));
      xi -= (corner[m][0][0] + corner[m][1][1]) + (corner[m][0][1] + corner[m][1][0]);
      eta -= (corner[0][m][0] + corner[1][m][1]) + (corner[0][m][1] + corner[1][m][0]);
      zeta -= (corner[0][0][m] + corner[1][1][m]) + (corner[0][1][m] + corner[1][0][m]);
      xi = smaller_floats(xi, smaller_floats(eta, zeta));
      centres = m == 0 ? xi : smaller_floats(centres, xi);
    }
    valid = float_lane_bits((least > error) & (middles > 2 * error) & (centres > 4 * error) & usable);
    invalid |= float_lane_bits(((edges < -4 * error) | (faces < -8 * error)) & usable);
  }
  for (int h = 0; h < FLOATS; h += 8) {
    uint64_t bytes = HL_VALID * bytes_of(valid >> h) + HL_INVALID * bytes_of(invalid >> h);
    __builtin_memcpy(verdicts + h, &bytes, FLOATS < 8 ? FLOATS : 8);
  }
}

/* Asks for the elements of some groups ahead, three lines of memory each: otherwise reading them takes as long as the rest. */
static inline void fetch_ahead(const double *group, int elements) {
  enum { AHEAD = 16, LINE = 8 };
  for (int line = 0; line < 3 * elements; ++line) __builtin_prefetch(group + 24 * AHEAD + LINE * line);
}

static void decide_block(const double *hexahedra, int count, unsigned char *verdicts) {
  for (int h = 0; h < count; h += FLOATS) {
    fetch_ahead(hexahedra + 24 * h, FLOATS);
    decide_group(hexahedra + 24 * h, verdicts + h);
  }
}

/* The edge vectors in scaled units (docs/algorithm.md 2). Gives the product of the axes' units, a bound for the permanents
   and which lanes it holds for. */
static inline double_bits scaled_edges(const doubles p[24], double_edges *e, doubles *unit, doubles *permanent) {
  double_bits usable = ~(double_bits){0};
  doubles bounds[3][3]; /* of the components of U, V, W by axis */
  *unit = all_doubles(1);
  for (int axis = 0; axis < 3; ++axis) {
    SUBTRACT_VERTICES(p, e, axis)
    doubles greatest[3] = {magnitude_of(e->u[0][0][axis]), magnitude_of(e->v[0][0][axis]),
                           magnitude_of(e->w[0][0][axis])};
    for (int m = 1; m < 4; ++m) {
      greatest[0] = larger_of(greatest[0], magnitude_of(e->u[m >> 1][m & 1][axis]));
      greatest[1] = larger_of(greatest[1], magnitude_of(e->v[m >> 1][m & 1][axis]));
      greatest[2] = larger_of(greatest[2], magnitude_of(e->w[m >> 1][m & 1][axis]));
    }
    doubles all = larger_of(larger_of(greatest[0], greatest[1]), greatest[2]);
    usable &= (all >= LEAST_DOUBLE) & (all <= GREATEST_DOUBLE);
    /* The power of two above it, and its reciprocal, by their bits: biased exponents add up to 2046. */
    double_words power = ((double_words)all & 0x7ff0000000000000u) + 0x0010000000000000u;
    doubles factor = (doubles)(0x7fe0000000000000u - power);
    *unit *= (doubles)power;
    for (int f = 0; f < 3; ++f) bounds[axis][f] = greatest[f] * factor;
    for (int m = 0; m < 2; ++m)
      for (int n = 0; n < 2; ++n) {
        e->u[m][n][axis] *= factor;
        e->v[m][n][axis] *= factor;
        e->w[m][n][axis] *= factor;
      }
  }
  const doubles *x = bounds[0], *y = bounds[1], *z = bounds[2];
  *permanent =
      x[0] * (y[1] * z[2] + y[2] * z[1]) + x[1] * (y[2] * z[0] + y[0] * z[2]) + x[2] * (y[0] * z[1] + y[1] * z[0]);
  return usable;
}

/* The operations of bernstein.c in their order, but for the cube's centre; twice the middles of edges and four times those of
   faces. */
static inline void group_bernstein(const double_edges *e, doubles b[27]) {
  doubles to_far_v[2][2][2], to_far_u[2][2][2];
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) {
        order_by_memory(e);
        doubles n[3];
        CROSS(e->u[j][k], e->v[i][k], n);
        b[bernstein_index(2 * i, 2 * j, 2 * k)] = DOT(n, e->w[i][j]);
        to_far_v[i][j][k] = DOT(n, e->w[1 - i][j]);
        to_far_u[i][j][k] = DOT(n, e->w[i][1 - j]);
      }
  for (int m = 0; m < 2; ++m)
    for (int k = 0; k < 2; ++k) {
      b[bernstein_index(1, 2 * m, 2 * k)] = to_far_v[0][m][k] + to_far_v[1][m][k];
      b[bernstein_index(2 * m, 1, 2 * k)] = to_far_u[m][0][k] + to_far_u[m][1][k];
    }
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      doubles n[3], other[3];
      CROSS(e->u[j][0], e->v[i][1], n);
      CROSS(e->u[j][1], e->v[i][0], other);
      for (int r = 0; r < 3; ++r) n[r] += other[r];
      b[bernstein_index(2 * i, 2 * j, 1)] = DOT(n, e->w[i][j]);
    }
  for (int face = 0; face < 6; ++face) {
    int s = axis_stride[face_table[face].s], t = axis_stride[face_table[face].t];
    doubles *c = b + face_middle(face);
    doubles middles = (c[-s] + c[s]) + (c[-t] + c[t]);
    doubles corners = (c[-s - t] + c[s + t]) + (c[-s + t] + c[s - t]);
    *c = middles - corners;
  }
}

static inline void corners_of_group(const double *hexahedra, int first, lane_minima *out) {
  doubles p[24], b[27], unit, permanent;
  for (int g = 0; g < 12; ++g) load_pair(hexahedra, g, p + 2 * g);
  double_edges e;
  order_by_memory(p);
  double_bits usable = scaled_edges(p, &e, &unit, &permanent);
  b[CUBE_CENTRE] = all_doubles(0);
  order_by_memory(b);
  group_bernstein(&e, b);

  doubles least = b[0], greatest = b[0], sum = b[0];
  double_bits vertex = {0};
  for (int v = 1; v < 8; ++v) {
    doubles corner = b[vertex_index(v)];
    double_bits is_less = corner < least;
    vertex = (vertex & ~is_less) | (is_less & v);
    least = smaller_of(least, corner);
    greatest = larger_of(greatest, corner);
    sum += corner;
  }
  doubles of_edges = b[edge_bernstein[0]], of_faces = b[face_middle(0)];
  for (int i = 1; i < 12; ++i) of_edges = smaller_of(of_edges, b[edge_bernstein[i]]);
  for (int i = 1; i < 6; ++i) of_faces = smaller_of(of_faces, b[face_middle(i)]);
  doubles others = smaller_of(0.5 * of_edges, 0.25 * of_faces);
  usable &= sum == sum;               /* a coordinate that is not finite makes the corner NaN */
  doubles value = least * unit + 0.0; /* -0 becomes 0 */
  double_bits lower = (others < least);
  double_bits invalid = (least < -CORNER_ERROR);
  double_bits valid = (smaller_of(least, others) > FACE_BERNSTEIN_ERROR);
  double_bits accurate = (larger_of(greatest, -least) > permanent * LEAST_PART_IN_LANES);
  /* Then the least corner is at least 49u times a unit of at least 2^-750: a normal double. */
  double_bits positive = (greatest > CORNER_ERROR);
  double_bits settled = usable & accurate & (valid | invalid) & ~lower;
  double_bits state = (usable & LANE_USABLE) | (valid & LANE_VALID) | (invalid & LANE_INVALID) |
                      (accurate & LANE_ACCURATE) | (settled & LANE_SETTLED) | (positive & LANE_POSITIVE);
  for (int h = 0; h < DOUBLES; ++h) {
    out->state[first + h] = (unsigned char)state[h];
    out->vertex[first + h] = (unsigned char)vertex[h];
  }
  *(doubles *)(out->least + first) = value;
  *(doubles *)(out->unit + first) = unit;
  if (lane_bits(settled) != (1u << DOUBLES) - 1)
    for (int i = 0; i < 27; ++i) *(doubles *)(out->bernstein + 27 * first + DOUBLES * i) = b[i];
}

static void corners_of_block(const double *hexahedra, int count, lane_minima *out) {
  for (int h = 0; h < count; h += DOUBLES) {
    fetch_ahead(hexahedra + 24 * h, DOUBLES);
    corners_of_group(hexahedra + 24 * h, h, out);
  }
}

/* Adds the determinant of three columns; returns the product of their sums of magnitudes. */
static inline doubles add_determinant(const doubles a[3], const doubles b[3], const doubles c[3], doubles *sum) {
  doubles n[3];
  CROSS(a, b, n);
  *sum += DOT(n, c);
  return (magnitude_of(a[0]) + magnitude_of(a[1]) + magnitude_of(a[2])) *
         (magnitude_of(b[0]) + magnitude_of(b[1]) + magnitude_of(b[2])) *
         (magnitude_of(c[0]) + magnitude_of(c[1]) + magnitude_of(c[2]));
}

/* The columns of volume_columns. */
static inline void volumes_of_group(const double *hexahedra, int first, lane_volumes *out) {
  doubles p[24], volume = all_doubles(0), size;
  for (int g = 0; g < 12; ++g) load_pair(hexahedra, g, p + 2 * g);
  doubles from_1[3], from_0[3], from_3[3], to_2[3], to_5[3], from_4[3], sums[3][3];
  for (int r = 0; r < 3; ++r) {
    from_1[r] = p[18 + r] - p[3 + r];
    from_0[r] = p[21 + r] - p[r];
    from_3[r] = p[18 + r] - p[9 + r];
    to_2[r] = p[6 + r] - p[r];
    to_5[r] = p[15 + r] - p[r];
    from_4[r] = p[18 + r] - p[12 + r];
    sums[0][r] = from_1[r] + from_0[r];
    sums[1][r] = from_3[r] + to_5[r];
    sums[2][r] = from_4[r] + to_2[r];
  }
  size = add_determinant(sums[0], from_3, to_2, &volume);
  size += add_determinant(from_0, sums[1], from_4, &volume);
  size += add_determinant(from_1, to_5, sums[2], &volume);
  *(doubles *)(out->twelvefold + first) = volume;
  *(doubles *)(out->size + first) = size;
}

static void volumes_of_block(const double *hexahedra, int count, lane_volumes *out) {
  for (int h = 0; h < count; h += DOUBLES) volumes_of_group(hexahedra + 24 * h, h, out);
}

/* The operations of integral.c in their order. */
typedef struct pairs {
  doubles high, low;
} pairs;

static inline pairs exact_sums(doubles a, doubles b) {
  const doubles sum = a + b, b_part = sum - a;
  return (pairs){sum, (a - (sum - b_part)) + (b - b_part)};
}

/* A double as two of 26 bits. */
static inline pairs halves_of(doubles a) {
  const doubles c = 134217729 * a, high = c - (c - a);
  return (pairs){high, a - high};
}

static inline pairs exact_products(doubles a, pairs a_halves, doubles b, pairs b_halves) {
  const doubles product = a * b;
  return (pairs){product, ((a_halves.high * b_halves.high - product) + a_halves.high * b_halves.low +
                           a_halves.low * b_halves.high) +
                              a_halves.low * b_halves.low};
}

static inline pairs renewed_pairs(doubles high, doubles low) {
  const doubles sum = high + low;
  return (pairs){sum, low - (sum - high)};
}

static inline pairs sums_of(pairs a, pairs b) {
  const pairs high = exact_sums(a.high, b.high), low = exact_sums(a.low, b.low);
  const pairs first = renewed_pairs(high.high, high.low + low.high);
  return renewed_pairs(first.high, first.low + low.low);
}

/* Entries of a column, and the halves of their first doubles. */
typedef struct split_pairs {
  pairs value, halves;
} split_pairs;

static inline split_pairs split(pairs a) { return (split_pairs){a, halves_of(a.high)}; }

static inline pairs products_of(split_pairs a, split_pairs b) {
  const pairs high = exact_products(a.value.high, a.halves, b.value.high, b.halves);
  return renewed_pairs(high.high, high.low + (a.value.high * b.value.low + a.value.low * b.value.high));
}

/* Three calls: inlined, they would be most of the kernel's code. */
__attribute__((noinline)) static void add_exact_determinant(const split_pairs a[3], const split_pairs b[3],
                                                            const split_pairs c[3], pairs *total, doubles *size) {
  for (int r = 0; r < 3; ++r) {
    const int s = (r + 1) % 3, t = (r + 2) % 3;
    pairs other = products_of(a[t], b[s]);
    other.high = -other.high;
    other.low = -other.low;
    const split_pairs minor = split(sums_of(products_of(a[s], b[t]), other));
    *total = sums_of(*total, products_of(minor, c[r]));
    *size += (magnitude_of(a[s].value.high) * magnitude_of(b[t].value.high) +
              magnitude_of(a[t].value.high) * magnitude_of(b[s].value.high)) *
             magnitude_of(c[r].value.high);
  }
}

/* (V0), with twice its bound. */
static inline void nearest_volumes_of_group(const double *hexahedra, int first, lane_nearest_volumes *out) {
  doubles p[24], size = all_doubles(0);
  double_bits found = ~(double_bits){0};
  for (int g = 0; g < 12; ++g) load_pair(hexahedra, g, p + 2 * g);
  for (int i = 0; i < 24; ++i) {
    const doubles magnitude = magnitude_of(p[i]);
    found &= (magnitude <= GREATEST_COORDINATE) & ((magnitude >= LEAST_COORDINATE) | (magnitude == 0));
  }
  split_pairs differences[6][3], sums[3][3];
  static const unsigned char ends[6][2] = {{1, 6}, {0, 7}, {3, 6}, {0, 2}, {0, 5}, {4, 6}};
  static const unsigned char summed[3][2] = {{0, 1}, {2, 4}, {5, 3}};
  for (int d = 0; d < 6; ++d)
    for (int r = 0; r < 3; ++r) differences[d][r] = split(exact_sums(p[3 * ends[d][1] + r], -p[3 * ends[d][0] + r]));
  for (int d = 0; d < 3; ++d)
    for (int r = 0; r < 3; ++r)
      sums[d][r] = split(sums_of(differences[summed[d][0]][r].value, differences[summed[d][1]][r].value));
  pairs total = {all_doubles(0), all_doubles(0)};
  add_exact_determinant(sums[0], differences[2], differences[3], &total, &size);
  add_exact_determinant(differences[1], sums[1], differences[5], &total, &size);
  add_exact_determinant(differences[0], differences[4], sums[2], &total, &size);

  const doubles quotient = total.high / 12, twelve = all_doubles(12);
  const pairs product = exact_products(quotient, halves_of(quotient), twelve, halves_of(twelve));
  const doubles rest = ((total.high - product.high) - product.low + total.low) / 12;
  const pairs result = renewed_pairs(quotient, rest);
  const doubles error = 2 * (size * PAIR_ERROR + magnitude_of(result.high) * PAIR_ERROR);
  found &= (result.high + (result.low + error) == result.high) & (result.high + (result.low - error) == result.high);
  *(doubles *)(out->volume + first) = result.high + 0.0; /* -0 becomes 0 */
  for (int h = 0; h < DOUBLES; ++h) out->is_found[first + h] = (unsigned char)(found[h] & 1);
}

static void nearest_volumes_of_block(const double *hexahedra, int count, lane_nearest_volumes *out) {
  for (int h = 0; h < count; h += DOUBLES) nearest_volumes_of_group(hexahedra + 24 * h, h, out);
}

/* Three vectors hold whole triples of coordinates, whatever the width: entry i of an element is on axis i % 3. */
static void widen_by_block(const double *hexahedra, int count, double box[6]) {
  doubles least[3], greatest[3];
  for (int i = 0; i < 3 * DOUBLES; ++i) {
    least[i / DOUBLES][i % DOUBLES] = box[i % 3];
    greatest[i / DOUBLES][i % DOUBLES] = box[3 + i % 3];
  }
  for (int at = 0; at < 24 * count; at += 3 * DOUBLES)
    for (int v = 0; v < 3; ++v) {
      doubles own;
      __builtin_memcpy(&own, hexahedra + at + v * DOUBLES, sizeof own);
      least[v] = smaller_of(least[v], own);
      greatest[v] = larger_of(greatest[v], own);
    }
  for (int i = 0; i < 3 * DOUBLES; ++i) {
    const double low = least[i / DOUBLES][i % DOUBLES], high = greatest[i / DOUBLES][i % DOUBLES];
    if (low < box[i % 3]) box[i % 3] = low;
    if (high > box[3 + i % 3]) box[3 + i % 3] = high;
  }
}

#define KERNELS_(name) lanes_##name
#define KERNELS(name) KERNELS_(name)
#define STRING_(name) #name
#define STRING(name) STRING_(name)
const lane_kernels KERNELS(LANES) = {
    STRING(LANES), DOUBLES, decide_block, corners_of_block, volumes_of_block, nearest_volumes_of_block, widen_by_block};
