/* The fast stage of batches: several elements side by side in SIMD lanes (docs/algorithm.md 10). One kernel source,
   lanes_kernel.h, compiled for each instruction set; whatever it decides the scalar code decides alike. */
#ifndef HL_LANES_H
#define HL_LANES_H

/* Elements that a kernel is given at once; memory for all of them must be readable, however few of them count. */
enum { HL_BLOCK = 128 };

/* Findings about one element, bit by bit. */
enum {
  LANE_USABLE = 1, /* finite, and of a size for which plain doubles and powers of two do */
  LANE_VALID = 2,
  LANE_INVALID = 4,
  LANE_ACCURATE = 8, /* the largest coefficient is not small beside the permanents, (M2) */
  LANE_SETTLED = 16, /* all of it: the least corner is the minimum, and the verdict is certain */
  LANE_POSITIVE = 32 /* a corner is certainly positive */
};

typedef struct lane_minima {
  unsigned char state[HL_BLOCK];
  unsigned char vertex[HL_BLOCK];      /* of the least corner, the first of equals */
  _Alignas(64) double least[HL_BLOCK]; /* its jacdet */
  _Alignas(64) double unit[HL_BLOCK];  /* a power of two: jacdet is the number in scaled units times this */
  /* Coefficients in scaled units, before they are multiplied by bernstein_factor: of element e,
     number i is at [e / width][i][e % width]; only where its group has an element that is not
     settled. The cube's centre is not computed. */
  _Alignas(64) double bernstein[27 * HL_BLOCK];
} lane_minima;

/* Twelve times the volumes as doubles find them, and what bounds their errors, (V7). */
typedef struct lane_volumes {
  _Alignas(64) double twelvefold[HL_BLOCK];
  _Alignas(64) double size[HL_BLOCK];
} lane_volumes;

/* Volumes as they are where `is_found`: the nearest doubles. */
typedef struct lane_nearest_volumes {
  _Alignas(64) double volume[HL_BLOCK];
  unsigned char is_found[HL_BLOCK];
} lane_nearest_volumes;

typedef struct lane_kernels {
  const char *name;
  int width; /* elements in one vector of doubles */
  /* Verdicts (hl_verdict) of `count` elements of 24 doubles each, HL_UNANSWERED for whatever is not clear in floats. There is
     room for a whole block. */
  void (*decide)(const double *hexahedra, int count, unsigned char *verdicts);
  /* Least corners and all coefficients in doubles, the very bits of jacdet_bernstein but for
     bernstein_factor and the sign of zero. */
  void (*corners)(const double *hexahedra, int count, lane_minima *out);
  void (*volumes)(const double *hexahedra, int count, lane_volumes *out);
  void (*nearest_volumes)(const double *hexahedra, int count, lane_nearest_volumes *out);
  /* Least x, y and z, then the greatest, of what is there and of all elements, which are finite. */
  void (*widen)(const double *hexahedra, int count, double box[6]);
} lane_kernels;

/* The widest that this machine runs, or null where there is none: then everything is done one by one. */
const lane_kernels *best_lanes(void);

extern const lane_kernels lanes_sse2, lanes_avx2, lanes_avx512, lanes_wasm;

#endif
