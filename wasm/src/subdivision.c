#include "subdivision.h"
#include "bernstein.h"
#include "topology.h"

void halve_along(const double bernstein[27], int axis, double lower[27], double upper[27]) {
  int stride = axis_stride[axis];
  for (int row = 0; row < 9; ++row) {
    int first = first_of_row(axis, row), middle = first + stride, last = middle + stride;
    double below = 0.5 * (bernstein[first] + bernstein[middle]), above = 0.5 * (bernstein[middle] + bernstein[last]);
    double between = 0.5 * (below + above);
    lower[first] = bernstein[first];
    lower[middle] = below;
    lower[last] = between;
    upper[first] = between;
    upper[middle] = above;
    upper[last] = bernstein[last];
  }
}

double least_coefficient(const double bernstein[27]) {
  double least = bernstein[0];
  for (int i = 1; i < 27; ++i) least = smaller(least, bernstein[i]);
  return least;
}
