/* The tables of topology.h against the few that the others follow from: vertex_reference, edge_table, face_table, axis_stride. */
#include "../../wasm/src/bernstein.h"
#include "../../wasm/src/topology.h"
#include "check.h"
#include "hexlens.h"
#include "random.h"

static int sum_of_strides(const unsigned char reference[3]) {
  return 2 * (reference[0] * axis_stride[0] + reference[1] * axis_stride[1] + reference[2] * axis_stride[2]);
}

static void vertices_are_in_vtk_order(void) {
  for (int v = 0; v < HL_VERTICES; ++v) {
    const unsigned char *r = vertex_reference[v];
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(r[axis] == unit_cube[3 * v + axis], "vertex %d, axis %d", v, axis);
      CHECK(vertex_point[v][axis] == r[axis], "point of vertex %d, axis %d", v, axis);
    }
    CHECK(vertex_at[r[0]][r[1]][r[2]] == v, "vertex_at of %d", v);
    CHECK(vertex_index(v) == sum_of_strides(r), "coefficient of vertex %d", v);
  }
}

static void indices_are_sums_of_strides(void) {
  CHECK(CUBE_CENTRE == bernstein_index(1, 1, 1), "centre");
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) {
        const int index = bernstein_index(i, j, k), ones = (i == 1) + (j == 1) + (k == 1);
        CHECK(index == i * axis_stride[0] + j * axis_stride[1] + k * axis_stride[2], "index of %d%d%d", i, j, k);
        CHECK(axis_digit(index, 0) == i && axis_digit(index, 1) == j && axis_digit(index, 2) == k, "%d", index);
        CHECK(bernstein_factor[index] == (ones == 3 ? 1 : 1.0 / (1 << ones)), "part of %d", index);
      }
}

static void rows_hold_each_coefficient_once(void) {
  for (int axis = 0; axis < 3; ++axis) {
    uint32_t seen = 0;
    for (int row = 0; row < 9; ++row)
      for (int i = 0; i < 3; ++i) {
        const int index = first_of_row(axis, row) + i * axis_stride[axis];
        CHECK(axis_digit(index, axis) == i, "axis %d, row %d", axis, row);
        seen |= (uint32_t)1 << index;
      }
    CHECK(seen == (1u << HL_BERNSTEIN) - 1, "axis %d", axis);
  }
}

static void edges_rise_along_their_axis(void) {
  uint32_t seen = 0;
  for (int e = 0; e < HL_EDGES; ++e) {
    const int axis = edge_table[e].axis, from = edge_table[e].from;
    CHECK(vertex_reference[from][axis] == 0, "edge %d", e);
    CHECK(edge_bernstein[e] == vertex_index(from) + axis_stride[axis], "middle of edge %d", e);
    seen |= (uint32_t)1 << edge_bernstein[e];
  }
  CHECK(__builtin_popcount(seen) == HL_EDGES, "%x", seen);
}

static void faces_hold_what_lies_on_their_side(void) {
  for (int f = 0; f < HL_FACES; ++f) {
    const int axis = face_table[f].axis, side = face_table[f].side, s = face_table[f].s, t = face_table[f].t;
    CHECK(f == 2 * axis + side && s == (axis == 0 ? 1 : 0) && t == (axis == 2 ? 1 : 2), "face %d", f);
    uint32_t bits = 0, middles = (uint32_t)1 << (HL_EDGES + f);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int index = 2 * side * axis_stride[axis] + i * axis_stride[s] + j * axis_stride[t];
        CHECK(face_coefficients[f][3 * i + j] == index, "face %d, coefficient %d%d", f, i, j);
        bits |= (uint32_t)1 << index;
      }
    for (int e = 0; e < HL_EDGES; ++e) middles |= (bits >> edge_bernstein[e] & 1) << e;
    CHECK(face_middle(f) == CUBE_CENTRE + (2 * side - 1) * axis_stride[axis], "middle of face %d", f);
    CHECK(face_coefficient_bits[f] == bits, "face %d: %x", f, bits);
    CHECK(face_middle_bits[f] == middles, "face %d: %x", f, middles);
  }
}

int main(void) {
  RUN(vertices_are_in_vtk_order);
  RUN(indices_are_sums_of_strides);
  RUN(rows_hold_each_coefficient_once);
  RUN(edges_rise_along_their_axis);
  RUN(faces_hold_what_lies_on_their_side);
  return test_summary();
}
