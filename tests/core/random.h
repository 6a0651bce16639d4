/* Replayable random numbers: splitmix64 (Steele, Lea and Flood 2014), normals by the polar method. */
#ifndef RANDOM_H
#define RANDOM_H

#include <math.h>
#include <stdint.h>

typedef struct random_stream {
  uint64_t state;
} random_stream;

static inline uint64_t random_bits(random_stream *stream) {
  uint64_t z = stream->state += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

/* A number in [0,1). */
static inline double random_unit(random_stream *stream) { return (double)(random_bits(stream) >> 11) * 0x1p-53; }

static inline double random_normal(random_stream *stream) {
  for (;;) {
    double x = 2 * random_unit(stream) - 1, y = 2 * random_unit(stream) - 1, r = x * x + y * y;
    if (r > 0 && r < 1) return x * sqrt(-2 * log(r) / r);
  }
}

static const double unit_cube[24] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};

/* The paper's elements: the unit cube with independent normal displacements of all 24 coordinates. */
static inline void random_hexahedron(random_stream *stream, double sigma, double vertices[24]) {
  for (int i = 0; i < 24; ++i) vertices[i] = unit_cube[i] + sigma * random_normal(stream);
}

#endif
