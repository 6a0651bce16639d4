/* One hexahedron, then a small mesh, with the C library. docs/c-library.md says how to compile it. */
#include <hexlens.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>

/* All eight vertices and all twelve edges are positive; on a face jacdet is negative. */
static const double hexahedron[HL_COORDINATES] = {
    0.5,  0.25, 0.25, /* 0 */
    1,    0,    1,    /* 1 */
    0.5,  0.75, 0.25, /* 2 */
    0,    1,    1,    /* 3 */
    0,    0,    0,    /* 4 */
    0.75, 0.5,  0.75, /* 5 */
    1,    1,    0,    /* 6 */
    0.25, 0.5,  0.75  /* 7 */
};

/* Three cubes in a row along x. Point 15 is too far back, so that the last cell is folded. */
static const double points[3 * 16] = {
    0, 0, 0, 1, 0, 0, 2, 0, 0, 3,   0, 0, /* y = 0, z = 0 */
    0, 1, 0, 1, 1, 0, 2, 1, 0, 3,   1, 0, /* y = 1, z = 0 */
    0, 0, 1, 1, 0, 1, 2, 0, 1, 3,   0, 1, /* y = 0, z = 1 */
    0, 1, 1, 1, 1, 1, 2, 1, 1, 1.5, 1, 1  /* y = 1, z = 1 */
};

enum { CELLS = 3 };

static const uint32_t indices[HL_VERTICES * CELLS] = {
    0, 1, 5, 4, 8,  9,  13, 12, /* cell 0 */
    1, 2, 6, 5, 9,  10, 14, 13, /* cell 1 */
    2, 3, 7, 6, 10, 11, 15, 14  /* cell 2 */
};

static int decide_hexahedron(void) {
  hl_verdict verdict;
  hl_minimum least;
  if (hl_decide(hexahedron, &verdict) != HL_OK || hl_boundary_minimum(hexahedron, HL_ROOTS_B, &least) != HL_OK) {
    fputs("A coordinate is not finite.\n", stderr);
    return 1;
  }
  const double *point = least.minimizer.point;
  printf("The hexahedron is %s: jacdet is %.6f at xi, eta, zeta = %.6f, %.6f, %.6f.\n",
         verdict == HL_VALID ? "valid" : "invalid", ldexp(least.minimizer.value, least.exponent), point[0], point[1],
         point[2]);
  return 0;
}

static int classify_mesh(void) {
  uint8_t verdicts[CELLS];
  double minima[CELLS], minimizers[3 * CELLS], corner_minima[CELLS];
  int16_t exponents[CELLS];
  hl_cells cells = {.coordinates = points,
                    .coordinate_count = sizeof points / sizeof points[0],
                    .indices = indices,
                    .index_count = sizeof indices / sizeof indices[0]};
  hl_batch batch = {.verdicts = verdicts,
                    .minima = minima,
                    .minimizers = minimizers,
                    .corner_minima = corner_minima,
                    .exponents = exponents};
  if (hl_classify(&cells, &batch) != HL_OK) {
    fputs("The mesh is not one of hexahedra with finite coordinates.\n", stderr);
    return 1;
  }
  printf("%zu of %d cells are valid.\n", batch.valid, CELLS);
  for (int c = 0; c < CELLS; ++c)
    if (verdicts[c] == HL_INVALID)
      printf("Cell %d is invalid: jacdet is %g at %g, %g, %g.\n", c, ldexp(minima[c], exponents[c]), minimizers[3 * c],
             minimizers[3 * c + 1], minimizers[3 * c + 2]);
  return 0;
}

int main(void) {
  printf("Hexlens %s\n", hl_version());
  return decide_hexahedron() || classify_mesh();
}
