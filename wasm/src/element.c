/* An element's class, its coincident vertices and the shape they make, its relative minimum. */
#include "bernstein.h"
#include "error_bounds.h"
#include "exact.h"
#include "report.h"
#include "topology.h"

#include <float.h>
#include <math.h>

/* True if jacdet < 0 everywhere: that of the mirrored element, minus it, is then positive. */
static bool is_inverted(const double vertices[24]) {
  double mirrored[HL_COORDINATES];
  hl_verdict verdict = HL_INVALID;
  for (int i = 0; i < HL_COORDINATES; ++i) mirrored[i] = i % 3 == 0 ? -vertices[i] : vertices[i];
  hl_decide(mirrored, &verdict);
  return verdict == HL_VALID;
}

hl_class class_of(const double vertices[24], hl_verdict verdict) {
  if (verdict == HL_VALID) return HL_CLASS_VALID;
  edge_vectors edges;
  double bernstein[27];
  scaled_edge_vectors(vertices, &edges);
  jacdet_bernstein(&edges, bernstein);
  double greatest = bernstein[vertex_index(0)];
  for (int v = 1; v < HL_VERTICES; ++v) greatest = larger(greatest, bernstein[vertex_index(v)]);
  if (greatest > CORNER_ERROR) return HL_CLASS_INVALID;
  if (is_inverted(vertices)) return HL_CLASS_INVERTED;
  bernstein[CUBE_CENTRE] = 0;
  const bool may_be_zero = greatest_magnitude(bernstein, HL_BERNSTEIN) <= FACE_BERNSTEIN_ERROR;
  return may_be_zero && is_collapsed(vertices) ? HL_CLASS_COLLAPSED : HL_CLASS_INVALID;
}

static bool is_same_position(const double *p, const double *q) { return p[0] == q[0] && p[1] == q[1] && p[2] == q[2]; }

static int differing_axes(int v, int u) {
  int count = 0;
  for (int axis = 0; axis < 3; ++axis) count += vertex_reference[v][axis] != vertex_reference[u][axis];
  return count;
}

static int count_of(unsigned vertices) { return __builtin_popcount(vertices); }

/* Sets of vertices are bits. */
static bool is_edge(unsigned vertices) {
  const int first = __builtin_ctz(vertices), second = __builtin_ctz(vertices & (vertices - 1));
  return count_of(vertices) == 2 && differing_axes(first, second) == 1;
}

static bool has_face(unsigned vertices) {
  for (int f = 0; f < HL_FACES; ++f) {
    unsigned face = 0;
    for (int v = 0; v < HL_VERTICES; ++v)
      face |= (unsigned)(vertex_reference[v][face_table[f].axis] == face_table[f].side) << v;
    if ((vertices & face) == face) return true;
  }
  return false;
}

hl_shape find_coincidences(const double vertices[24], uint8_t coincident[8]) {
  unsigned groups[HL_VERTICES] = {0}, several[2] = {0, 0};
  int count = 0;
  for (int v = 0; v < HL_VERTICES; ++v) {
    int least = 0;
    while (!is_same_position(vertices + 3 * least, vertices + 3 * v)) ++least;
    coincident[v] = (uint8_t)least;
    groups[least] |= 1u << v;
  }
  for (int v = 0; v < HL_VERTICES; ++v)
    if (count_of(groups[v]) > 1) {
      if (count < 2) several[count] = groups[v];
      ++count;
    }
  if (count == 1 && has_face(several[0])) {
    if (count_of(several[0]) == 4) return HL_PYRAMID;
    return count_of(several[0]) == 5 ? HL_TETRAHEDRON : HL_NO_SHAPE;
  }
  if (count != 2) return HL_NO_SHAPE;
  if (is_edge(several[0]) && is_edge(several[1])) return has_face(several[0] | several[1]) ? HL_WEDGE : HL_NO_SHAPE;
  for (int g = 0; g < 2; ++g)
    if (is_edge(several[g]) && count_of(several[1 - g]) == 4 && has_face(several[1 - g])) return HL_TETRAHEDRON;
  return HL_NO_SHAPE;
}

double relative_minimum(double minimum, int exponent, double volume, int volume_exponent) {
  if (volume == 0) return NAN;
  if (minimum == 0) return 0;
  const int m = binary_exponent(minimum), v = binary_exponent(volume), power = exponent + m - volume_exponent - v;
  const double ratio = times_power_of_two(minimum, -m) / times_power_of_two(fabs(volume), -v);
  const double greatest = minimum < 0 ? -DBL_MAX : DBL_MAX, least = minimum < 0 ? -DBL_MIN : DBL_MIN;
  if (power > DBL_MAX_EXP) return greatest;
  if (power < DBL_MIN_EXP - 1) return least;
  const double value = times_power_of_two(ratio, power);
  if (value - value != 0) return greatest;
  return value < DBL_MIN && value > -DBL_MIN ? least : value;
}
