/* The positions of vertices, edges and faces, and the Bernstein coefficients on them.
   tests/core/test_topology.c derives each table from vertex_reference, edge_table, face_table and
   the strides. */
#ifndef HL_TOPOLOGY_H
#define HL_TOPOLOGY_H

#include <stdint.h>

/* Reference coordinates of the vertices, 0 or 1; the same as doubles; the vertex at [i][j][k]. */
static const unsigned char vertex_reference[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
static const double vertex_point[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                          {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
static const unsigned char vertex_at[2][2][2] = {{{0, 4}, {3, 7}}, {{1, 5}, {2, 6}}};

/* Compiled for size, a call would take longer than what these compute. */
#define HL_INLINE static inline __attribute__((always_inline))

/* The index of coefficient (i,j,k), and its numbers back. */
static const unsigned char axis_stride[3] = {9, 3, 1};
HL_INLINE int bernstein_index(int i, int j, int k) { return 9 * i + 3 * j + k; }
HL_INLINE int axis_digit(int index, int axis) { return index / axis_stride[axis] % 3; }
enum { CUBE_CENTRE = 13 };

/* An edge runs along `axis` from the vertex `from`; all twelve run in the direction of growing coordinate. */
static const struct {
  unsigned char axis, from;
} edge_table[12] = {{0, 0}, {1, 1}, {0, 3}, {1, 0}, {0, 4}, {1, 5}, {0, 7}, {1, 4}, {2, 0}, {2, 1}, {2, 3}, {2, 2}};

static const unsigned char edge_ends[12][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6},
                                               {7, 6}, {4, 7}, {0, 4}, {1, 5}, {3, 7}, {2, 6}};

/* A face fixes `axis` at `side`; s and t are the other two axes in ascending order. */
static const struct {
  unsigned char axis, side, s, t;
} face_table[6] = {{0, 0, 1, 2}, {0, 1, 1, 2}, {1, 0, 0, 2}, {1, 1, 0, 2}, {2, 0, 0, 1}, {2, 1, 0, 1}};

/* The first of each of the nine rows of three coefficients along an axis. */
static inline int first_of_row(int axis, int row) {
  return axis == 0 ? row : axis == 1 ? 9 * (row / 3) + row % 3 : 3 * row;
}

/* The coefficients of the vertices, and those in the middles of the edges and of the faces. */
static const unsigned char vertex_bernstein[8] = {0, 18, 24, 6, 2, 20, 26, 8};
static const unsigned char edge_bernstein[12] = {9, 21, 15, 3, 11, 23, 17, 5, 1, 19, 7, 25};

/* A face's nine, [3*i + j] with i in s and j in t. */
static const unsigned char face_coefficients[6][9] = {
    {0, 1, 2, 3, 4, 5, 6, 7, 8},       {18, 19, 20, 21, 22, 23, 24, 25, 26}, {0, 1, 2, 9, 10, 11, 18, 19, 20},
    {6, 7, 8, 15, 16, 17, 24, 25, 26}, {0, 3, 6, 9, 12, 15, 18, 21, 24},     {2, 5, 8, 11, 14, 17, 20, 23, 26}};

/* The coefficients on each face, as bits of their indices. */
static const uint32_t face_coefficient_bits[6] = {0x00001ff, 0x7fc0000, 0x01c0e07, 0x70381c0, 0x1249249, 0x4924924};
/* The edges of each face, and the face itself behind all edges, as bits. */
static const uint32_t face_middle_bits[6] = {0x01588, 0x02a22, 0x04311, 0x08c44, 0x1000f, 0x200f0};

static inline int vertex_index(int vertex) { return vertex_bernstein[vertex]; }
static inline int face_middle(int face) { return face_coefficients[face][4]; }

#endif
