/* The cells around a vertex that moves, in a frame that does not depend on how the input is turned, scaled, shifted or ordered; and
   jacdet of each as an affine function of the place: docs/repair.md (R1) to (R4). */
#ifndef HL_STAR_H
#define HL_STAR_H

#include "hexlens.h"

/* Frame axis a is sign[a] times the axis axis[a] of the input, a rotation in all. A place z of the frame is `origin`, the present
   place, plus 2^exponent times z turned back. */
typedef struct star_frame {
  double origin[3]; /* in the input's axes */
  int axis[3];
  double sign[3];
  int exponent;
  double low[3], high[3]; /* of z: the box (R14), less what the limits leave of it */
  int normal_count;
  double normals[2][3]; /* z is at right angles to these, which are orthonormal */
  const hl_limits *limits;
} star_frame;

/* The affine function gradient . z + constant, as four numbers. */
typedef struct affine {
  double gradient[3], constant;
} affine;

typedef struct star_cell {
  affine bernstein[HL_BERNSTEIN]; /* of jacdet, in units of 2^(3 exponent); that of the cube's centre is 0 */
  affine volume;
  double scale;    /* (R4) */
  uint64_t key;    /* of the order of cells in the frame */
  uint32_t number; /* in the input */
} star_cell;

/* Checks the star, finds its frame and fills one star_cell a cell, in the order of the frame. */
hl_status read_star(const hl_star *star, star_frame *frame, star_cell *cells);

size_t star_cell_count(const hl_star *star);

/* The 24 coordinates of a cell of the input with the moving vertex at `place`; these, turned into the frame's axes. */
void placed_cell(const hl_star *star, size_t cell, const double place[3], double vertices[HL_COORDINATES]);
void turned_cell(const star_frame *frame, double vertices[HL_COORDINATES]);

/* Takes out of a gradient what is along the normals. */
void project(const star_frame *frame, double gradient[3]);

/* The place of the input nearest to the place z of the frame, within the limits. */
void place_of(const star_frame *frame, const double z[3], double place[3]);

static inline double affine_at(const affine *f, const double z[3]) {
  return f->gradient[0] * z[0] + f->gradient[1] * z[1] + f->gradient[2] * z[2] + f->constant;
}

#endif
