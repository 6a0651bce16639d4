/* jacdet in Bernstein form on the hexahedron, its edges and its faces (docs/algorithm.md 3). */
#ifndef HL_BERNSTEIN_H
#define HL_BERNSTEIN_H

#include "scaling.h"
#include "topology.h"

#include <float.h>
#include <math.h>
#if defined __wasm_simd128__
#include <wasm_simd128.h>
#endif

/* The error bounds and the same bits everywhere need every operation rounded to double at once. */
_Static_assert(FLT_EVAL_METHOD == 0 && DBL_MANT_DIG == 53, "plain IEEE doubles");

/* y < x ? y : x and y > x ? y : x. Engines make a jump of WebAssembly's choice between two doubles, and one that is often
   mispredicted here; of its choice between vectors they do not. */
#if defined __wasm_simd128__
HL_INLINE double smaller(double x, double y) {
  return wasm_f64x2_extract_lane(wasm_f64x2_pmin(wasm_f64x2_splat(x), wasm_f64x2_splat(y)), 0);
}
HL_INLINE double larger(double x, double y) {
  return wasm_f64x2_extract_lane(wasm_f64x2_pmax(wasm_f64x2_splat(x), wasm_f64x2_splat(y)), 0);
}
#else
HL_INLINE double smaller(double x, double y) { return y < x ? y : x; }
HL_INLINE double larger(double x, double y) { return y > x ? y : x; }
#endif

/* (1-t) p + t q for t in [0,1], never outside [p,q]: rounding must not carry a value below its Bernstein bound. */
HL_INLINE double lerp(double p, double q, double t) {
  double r = (1 - t) * p + t * q;
  return smaller(larger(r, smaller(p, q)), larger(p, q));
}

/* The quadratic with Bernstein coefficients q0, q1, q2. */
static inline double quadratic_at(double q0, double q1, double q2, double t) {
  return lerp(lerp(q0, q1, t), lerp(q1, q2, t), t);
}

static inline double least_of(const double *values, int count) {
  double least = values[0];
  for (int i = 1; i < count; ++i) least = smaller(least, values[i]);
  return least;
}

static inline double greatest_magnitude(const double *x, int count) {
  double greatest = 0;
  for (int i = 0; i < count; ++i) greatest = larger(greatest, fabs(x[i]));
  return greatest;
}

static inline void cross(const double a[3], const double b[3], double out[3]) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* Factors: twice the middles of edges and four times those of faces are computed first. */
static const double bernstein_factor[27] = {1,    0.5, 1,    0.5, 0.25, 0.5, 1, 0.5, 1,    0.5, 0.25, 0.5, 0.25, 1,
                                            0.25, 0.5, 0.25, 0.5, 1,    0.5, 1, 0.5, 0.25, 0.5, 1,    0.5, 1};

/* The 27 coefficients from 16 cross products and 28 dot products, in the scaled units of the edge vectors. */
void jacdet_bernstein(const edge_vectors *edges, double bernstein[27]);

/* The largest permanent of |U|, |V|, |W| among the determinants that the coefficients are made of: what their errors are
   relative to, (8). */
double greatest_permanent(const edge_vectors *edges);

/* The nine of one face, [3*i + j] with i in s, j in t. */
void face_bernstein(const double bernstein[27], int face, double beta[9]);

#endif
