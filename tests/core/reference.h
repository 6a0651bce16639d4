/* jacdet straight from its definition, in long double and by no formula of the core; and the laws of a report. */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "check.h"
#include "hexlens.h"

#include <math.h>

#define UNIT_ROUNDOFF 0x1p-53

static const int reference_corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                           {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

static const int reference_edge[12][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6},
                                          {7, 6}, {4, 7}, {0, 4}, {1, 5}, {3, 7}, {2, 6}};

/* DF by the derivatives of the eight trilinear shape functions. */
static inline long double reference_jacdet(const double vertices[24], const double point[3]) {
  long double d[3][3] = {{0}};
  for (int v = 0; v < 8; ++v) {
    long double factor[3], slope[3];
    for (int axis = 0; axis < 3; ++axis) {
      factor[axis] = reference_corner[v][axis] ? (long double)point[axis] : 1 - (long double)point[axis];
      slope[axis] = reference_corner[v][axis] ? 1 : -1;
    }
    long double gradient[3] = {slope[0] * factor[1] * factor[2], factor[0] * slope[1] * factor[2],
                               factor[0] * factor[1] * slope[2]};
    for (int axis = 0; axis < 3; ++axis)
      for (int r = 0; r < 3; ++r) d[axis][r] += gradient[axis] * vertices[3 * v + r];
  }
  return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) - d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
         d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

/* The product over the axes of the largest edge component: a determinant of edge vectors is at most 6 of it. */
static inline double edge_product(const double vertices[24]) {
  double product = 1;
  for (int axis = 0; axis < 3; ++axis) {
    double greatest = 0;
    for (int e = 0; e < 12; ++e)
      greatest =
          fmax(greatest, fabs(vertices[3 * reference_edge[e][1] + axis] - vertices[3 * reference_edge[e][0] + axis]));
    product *= greatest;
  }
  return product;
}

/* |value of the core - jacdet| for ordinary sizes: 215 u of the Bernstein coefficients (8), and at most three roundings
   in each of four levels of de Casteljau's scheme on coefficients of at most 18. The scaled extent of an axis is up to
   twice its true one, eightfold in all. */
static inline double value_error(const double vertices[24]) {
  return (215 + 4 * 3 * 18) * UNIT_ROUNDOFF * 8 * edge_product(vertices);
}

/* Laws of every report whose exponent is 0. */
static inline void check_report(const double vertices[24], const hl_report *report, const char *what, long number) {
  double error = value_error(vertices);
  CHECK(report->exponent == 0, "%s %ld: exponent %d", what, number, report->exponent);
  CHECK(report->verdict == (report->minimizer.value > 0 ? HL_VALID : HL_INVALID), "%s %ld: verdict against its minimum",
        what, number);
  CHECK(report->minimizer.value <= report->edge_minimum && report->edge_minimum <= report->corner_minimum,
        "%s %ld: minima out of order", what, number);
  for (int i = 0; i < report->candidate_count; ++i) {
    const hl_candidate *c = &report->candidates[i];
    long double exact = reference_jacdet(vertices, c->point);
    CHECK(fabsl(exact - c->value) <= error, "%s %ld: candidate %d has %.17g, jacdet is %.17g", what, number, i,
          c->value, (double)exact);
    CHECK(c->value >= report->minimizer.value && c->value <= report->maximizer.value,
          "%s %ld: candidate %d outside minimum and maximum", what, number, i);
  }
  for (int f = 0; f < HL_FACES; ++f) {
    const hl_face_report *face = &report->faces[f];
    for (int i = 0; i < report->candidate_count; ++i)
      if (report->candidates[i].kind == HL_FACE && report->candidates[i].id == f)
        CHECK(report->candidates[i].value >= face->lower_bound, "%s %ld: face %d below its bound", what, number, f);
    for (int r = 0; r < face->root_count; ++r) {
      CHECK(face->roots[r].t > 0 && face->roots[r].t < 1, "%s %ld: root outside (0,1)", what, number);
      CHECK(r == 0 || face->roots[r].t > face->roots[r - 1].t, "%s %ld: roots not ascending", what, number);
      if (face->roots[r].fate == HL_ROOT_KEPT)
        CHECK(face->roots[r].s > 0 && face->roots[r].s < 1 && face->roots[r].a > 0, "%s %ld: root kept wrongly", what,
              number);
    }
  }
}

#endif
