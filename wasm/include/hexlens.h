/*
 * Hexlens: validity and boundary minimum of trilinear hexahedra. The whole public interface of the C core.
 *
 * A hexahedron is 24 doubles: eight vertices x, y, z in VTK_HEXAHEDRON order, at the reference coordinates
 *   0 (0,0,0)  1 (1,0,0)  2 (1,1,0)  3 (0,1,0)  4 (0,0,1)  5 (1,0,1)  6 (1,1,1)  7 (0,1,1).
 * Edges 0..11 are VTK's: 01 12 32 03, 45 56 76 47, 04 15 37 26. Faces 0..5 are -xi, +xi, -eta, +eta, -zeta, +zeta;
 * on a face (s, t) are the two other reference coordinates in the order xi, eta, zeta.
 *
 * jacdet is det DF of the trilinear map F from [0,1]^3 (length^3; on [-1,1]^3 it is an eighth). Every jacdet handed
 * out is its number times 2^exponent, with exponent 0 whenever all of them are normal doubles (or zero) as they are.
 * No function allocates, keeps state or writes through its input; outputs may not overlap inputs. So any number of threads may call
 * any function at once, each with outputs of its own. The arithmetic is IEEE double, + - * / sqrt and exact powers of two only, rounded
 * to nearest with subnormals kept, as C has it by default and WebAssembly always: the same bits everywhere. Formulas: docs/algorithm.md.
 *
 * Words. An element is *valid* if jacdet > 0 everywhere, else invalid. Its *class* says more of an invalid one: *inverted* if jacdet < 0
 * everywhere, *collapsed* if jacdet = 0 everywhere. The *boundary minimum* is the least jacdet on the six faces; the *relative minimum* is
 * that over |volume|, a number without a dimension, at most 1, and none (NaN) where the volume is 0. Vertices at the same position are
 * *coincident*, and an element that has some is *degenerate*; it is valid or invalid like any other, and invalid if two of a face
 * coincide. Its *shape* is what the coincidences make of it: a wedge, a pyramid, a tetrahedron, or none of them. *Worst first* is the order
 * of a list of cells: those with a negative minimum and no relative one, then by rising relative minimum, where a minimum of 0 without a
 * relative one counts as 0; ties by index.
 *
 * Costs, natively on one core of a Xeon server (npm run bench -- exact measures them again). Doubles answer for nearly every element;
 * integers do for the others, where a value is within rounding of 0 or coordinates span hundreds of powers of ten.
 *
 *                        doubles             integers, ordinary sizes     integers, any exponents
 *   hl_decide            0.2 us              0.02 us if two vertices      0.01 to 0.2 ms
 *                                            of a face coincide; 2 us
 *   hl_boundary_minimum  1 to 2 us           10 to 40 us                  1 ms
 *   hl_analyze           8 to 13 us          70 to 200 us                 2 to 5 ms
 *   hl_classify, a cell  22 to 33 ns, with   as hl_decide, with minima    as above
 *                        minima 32 to 130    as hl_boundary_minimum
 *
 * hl_tangent_bound takes 1.3 us, hl_jacobian_at and hl_unit_roots less than 1 us. The hardest elements, made so that jacdet cancels to a
 * 2^-6000th of its terms, take seconds.
 *
 * Memory is on the stack: 10 kB for doubles, in hl_classify 100 kB. Integers take 20 kB more at first, 160 kB where that is not enough,
 * and 2.6 MB where coordinates span hundreds of powers of two: 3 MB of stack are enough for everything.
 */
#ifndef HEXLENS_H
#define HEXLENS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The version of this header; hl_version() is that of the library. Before 1.0 another minor version may change the interface. */
#define HL_VERSION "0.1.0"
#define HL_VERSION_MAJOR 0
#define HL_VERSION_MINOR 1
#define HL_VERSION_PATCH 0

#ifdef __cplusplus
extern "C" {
#endif

/* The library hides all else. */
#if defined __GNUC__
#pragma GCC visibility push(default)
#endif

enum {
  HL_COORDINATES = 24,
  HL_VERTICES = 8,
  HL_EDGES = 12,
  HL_FACES = 6,
  HL_BERNSTEIN = 27,
  HL_FACE_BERNSTEIN = 9,
  HL_QUARTIC = 5,
  HL_MAX_ROOTS = 4,
  HL_CHECKS = 8,
  HL_MAX_CANDIDATES = HL_VERTICES + HL_EDGES + HL_FACES * HL_MAX_ROOTS
};

/* A failure is a status, never a number. On failure the output is left as it was. */
typedef enum hl_status {
  HL_OK = 0,
  HL_NOT_FINITE = 1,         /* a coordinate is NaN or infinite */
  HL_OUTSIDE_CUBE = 2,       /* a reference point is not in [0,1]^3 */
  HL_INCOMPLETE = 3,         /* a list of coordinates or of indices does not end with a whole cell (or point) */
  HL_NO_SUCH_POINT = 4,      /* an index is not that of a point */
  HL_NO_SUCH_RESOLUTION = 5, /* a number of tangents is not 1 to 8 */
  HL_MISSING_LIST =
      6, /* a batch without verdicts, or with values and without their exponents; a star without cells, or with
            neither indices nor bits */
  HL_NOTHING_MOVES = 7,  /* a cell of a star has no vertex that moves */
  HL_SEVERAL_PLACES = 8, /* the moving vertices of a star are not at one position */
  HL_OUTSIDE_LIMITS =
      9,         /* the present place of a star is not within its limits, or two normals are as good as parallel */
  HL_NO_ROOM = 9 /* the memory that was given is too small */
} hl_status;

/* Certain for every element of 24 finite doubles. Unanswered is, in a batch, a cell that is not one: its status says why. */
typedef enum hl_verdict { HL_UNANSWERED = 0, HL_VALID = 1, HL_INVALID = 2 } hl_verdict;

/* Valid; inverted, jacdet < 0 everywhere; collapsed, jacdet = 0 everywhere; otherwise invalid. */
typedef enum hl_class {
  HL_CLASS_UNANSWERED = 0,
  HL_CLASS_VALID = 1,
  HL_CLASS_INVALID = 2,
  HL_CLASS_INVERTED = 3,
  HL_CLASS_COLLAPSED = 4
} hl_class;

/* Shapes of elements with coincident vertices, in any of the cube's 48 symmetries: a wedge, two
   parallel edges of a face of length 0; a pyramid, the vertices of a face at one point; a
   tetrahedron, these and two neighbours of the opposite face, or these and the fifth at the same
   point. */
typedef enum hl_shape { HL_NO_SHAPE = 0, HL_WEDGE = 1, HL_PYRAMID = 2, HL_TETRAHEDRON = 3 } hl_shape;

typedef enum hl_kind { HL_VERTEX = 0, HL_EDGE = 1, HL_FACE = 2 } hl_kind;

/* Algorithm 1 of the paper, without and with the Bernstein face bounds. Both give the same minimizer, bit for bit. */
typedef enum hl_variant { HL_ROOTS = 0, HL_ROOTS_B = 1 } hl_variant;

/* The fate of a root t of P: a candidate; or a(t) <= 0; or s* outside (0,1). */
typedef enum hl_root_fate { HL_ROOT_KEPT = 0, HL_ROOT_A_NOT_POSITIVE = 1, HL_ROOT_S_OUTSIDE = 2 } hl_root_fate;

/* Checks of other programs; each accepts an element if its number is positive, the last then
   certifies it. All but the second are jacdets. */
typedef enum hl_check {
  HL_CHECK_CORNERS = 0, /* the least at the eight vertices */
  HL_CHECK_CORNERS_AND_CENTRE =
      1,                  /* Verdict's scaled Jacobian: the least there and at (1/2,1/2,1/2), from -1 to 1; but 1e30 by
                             the rules (S1) and (S2) of docs/algorithm.md, as for a column of DF without length */
  HL_CHECK_GAUSS_2 = 2,   /* the least at the 2x2x2 Gauss points */
  HL_CHECK_GAUSS_3 = 3,   /* the least at the 3x3x3 Gauss points */
  HL_CHECK_EDGES = 4,     /* the least on the twelve edges */
  HL_CHECK_BERNSTEIN = 5, /* the least of the Bernstein coefficients, which follow from 20 samples */
  HL_CHECK_SUBDIVISION = 6, /* subdivision that gives up past depth 4: the number that ended it */
  HL_CHECK_TANGENTS = 7     /* hl_tangent_bound with four tangents: it certifies, or it does not, and never rejects */
} hl_check;

/* A boundary point that may be the minimizer. */
typedef struct hl_candidate {
  hl_kind kind;
  int id;             /* vertex 0..7, edge 0..11 or face 0..5 */
  double point[3];    /* xi, eta, zeta in [0,1] */
  double position[3]; /* F(point), in the units of the vertices */
  double value;       /* jacdet there */
} hl_candidate;

typedef struct hl_face_root {
  double t; /* in (0,1) */
  double a; /* a(t) of f = a s^2 + b s + c, a jacdet */
  double s; /* -b/(2a); meaningful only where a > 0 */
  hl_root_fate fate;
} hl_face_root;

typedef struct hl_face_report {
  double bernstein[HL_FACE_BERNSTEIN]; /* [3*i + j], i in s, j in t */
  double lower_bound;                  /* L_R, the least of the nine */
  double running_minimum;              /* M before this face */
  bool skipped_by_minimum_rule;        /* L_R >= M */
  bool skipped_by_validity_rule;       /* L_R > 0 */
  double quartic[HL_QUARTIC];          /* Bernstein coefficients of P on [0,1], times 2^quartic_exponent */
  int quartic_exponent;
  bool quartic_is_zero; /* |P| is within its own rounding error: the edges suffice */
  int root_count;
  hl_face_root roots[HL_MAX_ROOTS]; /* ascending in t */
} hl_face_report;

/* The least jacdet over the closed element is in [lower, upper]. It is at most upper at the exact place that `point` is rounded from;
   at `point` itself it can be above it by the rounding of its coordinates. */
typedef struct hl_volume_minimum {
  double lower, upper;
  double point[3], position[3];
} hl_volume_minimum;

typedef struct hl_report {
  hl_verdict verdict;
  bool
      is_exact; /* integers decided it, doubles did not: then each jacdet that they give is of exact sign and rounded once */
  int exponent;
  hl_candidate minimizer;
  double minimum_error; /* |minimizer.value - exact boundary minimum| is at most this; a jacdet */
  hl_volume_minimum volume_minimum;
  double checks[HL_CHECKS];
  hl_candidate maximizer;
  double corner_minimum;
  double edge_minimum;    /* over the twelve edges with their ends */
  double scaled_jacobian; /* the least at the vertices and the centre, from -1 to 1; 0 where a column of DF is 0 */
  double bernstein[HL_BERNSTEIN]; /* [9*i + 3*j + k], i in xi, j in eta, k in zeta */
  hl_face_report faces[HL_FACES];
  int candidate_count;
  hl_candidate candidates[HL_MAX_CANDIDATES]; /* vertices, then edges, then faces */
  hl_class element_class;
  hl_shape shape;
  uint8_t
      coincident[HL_VERTICES]; /* of each vertex the least vertex at the same position, itself if there is no other */
  double volume;               /* the mean of jacdet, rounded once; times 2^volume_exponent */
  int volume_exponent;
  double relative_minimum; /* minimizer.value over |volume|, a number without a dimension; NaN where the volume is 0 */
} hl_report;

typedef struct hl_minimum {
  hl_candidate minimizer;
  int exponent;
  bool is_exact; /* as in hl_report */
} hl_minimum;

typedef struct hl_bound {
  double value;
  int exponent;
} hl_bound;

/* DF at a point: component r of column c is columns[c][r] * 2^axis_exponent[r]; det DF is jacdet * 2^exponent. */
typedef struct hl_jacobian {
  double position[3];
  double columns[3][3];
  int axis_exponent[3];
  double jacdet;
  int exponent;
} hl_jacobian;

/* HL_VERSION of the library that the program runs with, as it was compiled. */
const char *hl_version(void);

/* Below, `vertices` are the 24 coordinates of one hexahedron in its own units, finite, of any size;
   none of the pointers may be null unless said. On HL_OK the whole output is written, else nothing
   is. A NaN or an infinity among the inputs is HL_NOT_FINITE. */

/* Everything about one hexahedron: all faces solved, whatever the rules would skip. `report` is written whole. If its jacdets span more
   than the doubles do in any one unit, those that are too small are the least normal double of their sign; hl_boundary_minimum has
   the minimum then, and the relative minimum is the quotient of what is exact. */
hl_status hl_analyze(const double vertices[HL_COORDINATES], hl_report *report);

/* The least jacdet on the boundary and where it is attained, by Algorithm 1: hl_analyze's minimizer. Where doubles are not accurate
   enough, in integers, which have no variants; then the value is of exact sign and within 2^-52 of itself. `variant` is HL_ROOTS or
   HL_ROOTS_B, which is faster. */
hl_status hl_boundary_minimum(const double vertices[HL_COORDINATES], hl_variant variant, hl_minimum *minimum);

/* A lower bound of jacdet over the element, `bound`, but for rounding, after the sufficient test of Knabner, Korotov and Summ (2003): with
   `tangents` of them, 1 to 8, to a quadratic in each of two variables, at equidistant points, both ends among them from two
   on. If it is positive, jacdet certainly is, everywhere; else nothing is known. The best of the three choices of the
   variables, so that it is the same however the vertices are numbered, but for rounding. Any other number of tangents is
   HL_NO_SUCH_RESOLUTION. */
hl_status hl_tangent_bound(const double vertices[HL_COORDINATES], int tangents, hl_bound *bound);

/* Decides if jacdet > 0 on the closed boundary, which decides the whole element (Knupp's
   conjecture, a theorem). Stops at the first value that is certainly negative. `verdict` is
   HL_VALID or HL_INVALID, for every finite element. */
hl_status hl_decide(const double vertices[HL_COORDINATES], hl_verdict *verdict);

/* The three columns dF/dxi, dF/deta, dF/dzeta and their determinant, in doubles, at `point`: xi, eta, zeta, each from 0 to 1, else the
   status is HL_OUTSIDE_CUBE. */
hl_status hl_jacobian_at(const double vertices[HL_COORDINATES], const double point[3], hl_jacobian *jacobian);

/* Roots in (0,1), strictly ascending, of the polynomial of degree `degree` <= 4 with the given Bernstein coefficients on
   [0,1], which are finite and of magnitude 2^1000 at most; returns how many. A root of even multiplicity is given once, one
   within 2^-53 of an end or of another root perhaps not at all. The zero polynomial has none. */
int hl_unit_roots(const double *bernstein, int degree, double roots[HL_MAX_ROOTS]);

/* Many hexahedra. `coordinates` may be null if there are none. With indices, cell c is the points indices[8c] to indices[8c + 7], point p the coordinates 3p to 3p + 2;
   without (null, 0), cell c is the coordinates 24c to 24c + 23. */
typedef struct hl_cells {
  const double *coordinates;
  size_t coordinate_count; /* of doubles: a multiple of 3, without indices of 24 */
  const uint32_t *indices;
  size_t index_count; /* a multiple of 8 */
} hl_cells;

/* The caller's lists, one entry a cell unless said. All but the verdicts may be null; what is not
   asked for costs nothing. No list may overlap another or the cells. Of a cell that is unanswered verdict and class are 0, the numbers
   NaN, the bits and exponents 0. */
typedef struct hl_batch {
  uint8_t *verdicts; /* hl_verdict */
  uint8_t *statuses; /* hl_status: HL_OK, HL_NOT_FINITE or HL_NO_SUCH_POINT */
  uint8_t *is_exact; /* 1 where integers decided, as hl_decide does, with minima as hl_analyze does; else 0 */
  uint8_t *classes;  /* hl_class */
  /* Bit 1 << c for each hl_check c that accepts the cell: its number in the report is positive. 3 us a cell, and of those that
     integers decide as long as hl_analyze. */
  uint16_t *accepted_by;
  /* A minimum and a least corner are their number times 2^exponent, with exponent 0 where both are then normal doubles or zero.
     Whoever asks for one of them asks for the exponents. If no exponent suits both, it suits the minimum, and the corner is the least or
     the greatest double of its sign. */
  double *minima;        /* the boundary minimum */
  double *minimizers;    /* three a cell: xi, eta, zeta */
  double *corner_minima; /* the least jacdet at the eight vertices */
  int16_t *exponents;
  double *relative_minima; /* as in hl_report */
  double *volumes;         /* as in hl_report, times 2^volume_exponent */
  int16_t *volume_exponents;
  /* Cells of each verdict; cells that integers decided, counted only with is_exact or minima; and
     the first cell that is unanswered, or the number of cells. */
  size_t valid, invalid, unanswered, exact, first_unanswered;
} hl_batch;

/* Verdicts of many cells, and what else is asked for, as one by one, bit for bit. A cell with a coordinate that is not finite or an index
   out of range is unanswered and does not stop the others. A list of a wrong length is refused whole (HL_INCOMPLETE), and so are missing
   lists (HL_MISSING_LIST): then
   nothing is written but the counts, all 0, and first_unanswered, the first cell that is not whole. Any number of cells at once or in
   pieces; the counts are those of this call. */
hl_status hl_classify(const hl_cells *cells, hl_batch *batch);

/* hl_classify's instructions here: "avx512", "avx2", "sse2", "wasm" (its vectors) or "scalar". */
const char *hl_vectors(void);

/* Where a vertex may go: coordinates from `low` to `high`, which may be infinite, and from the present place only at right angles to the
   normals. Two of them leave a line; one that is zero is none. Places are within the coordinates exactly, in a plane but for the rounding
   of coordinates. Normals that are an axis come first; then the coordinate on it stays as it is. */
typedef struct hl_limits {
  double low[3], high[3], normals[2][3];
} hl_limits;

/* A star: the cells around a vertex that moves, while all others stay. Cell c has the moving vertex at its vertices v with bit 1 << v of
   moving[c]; where `moving` is null, at those whose index is `vertex`. At least one a cell, and all at one position: the present place.
   In a cell with repeated nodes several move together. Without limits (null) it may go anywhere. */
typedef struct hl_star {
  hl_cells cells;
  const uint8_t *moving;
  uint32_t vertex;
  const hl_limits *limits;
} hl_star;

/* The measure of a place, the least over the cells of the boundary minimum over a length^3. By volume, that is the cell's volume with
   the vertex at this place: the relative minimum. By scale, it is the cube of the root mean square of the edges that do not move, which
   is the same for every place. Places are compared by volume where all cells are valid, else by scale; any valid one is better. */
typedef enum hl_measure { HL_BY_SCALE = 0, HL_BY_VOLUME = 1 } hl_measure;

/* A point of a cell that holds the value of every place down; its coordinates are multiples of 2^-26. The weights are those of jacdet
   over the cell's scale, and sum to 1 over the points. For HL_BOX_SIDE as its cell it is a side of the box in which places are sought, and
   `point` the outward normal of length 1; it is a side of the limits where these are nearer. */
enum { HL_MAX_HOLDS = 4 };
#define HL_BOX_SIDE 0xffffffffu
typedef struct hl_hold {
  uint32_t cell;
  double point[3];
  double weight;
  double scale;    /* of the cell, times 2^(3 unit_exponent); 1 for a side of the box */
  bool is_by_sign; /* jacdet there is to be positive, whatever the volume */
} hl_hold;

/* No place in the box has a greater value by `measure` than `bound`: the holds prove it, (R10) of docs/repair.md, but for rounding; a
   bound of 1 by volume needs none. By scale a bound of 0 or less says that no place makes all cells valid. */
typedef struct hl_place {
  double position[3]; /* the present one, or one where the cells are better */
  bool is_moved;
  bool is_closed; /* bound - value is at most a millionth of |value|, or 2^-40 if that is more */
  hl_measure measure;
  double value, bound; /* the value is from the cells' boundary minima with the vertex at the position */
  double relative_minimum, present_relative_minimum; /* the least of the cells'; NaN where a cell has none */
  int unit_exponent; /* of the greatest offset of a coordinate from the present place, rounded up to a power of two */
  int round_count;   /* of looking for the least jacdets of all cells */
  int hold_count;
  hl_hold holds[HL_MAX_HOLDS];
} hl_place;

/* Bytes for so many cells around a vertex, 58 kB for eight. */
size_t hl_best_place_room(size_t cell_count);

/* The best place of the vertex within its limits and the box of half side 2^(20 + unit_exponent) around the present place; of several the one nearest to
   that, up to the gap. `memory` is aligned for doubles and of hl_best_place_room bytes at least, and holds nothing
   afterwards. However the star is turned by right angles about the axes, scaled by a power of two or its cells ordered, the place has the
   same bits, if they tell the axes and the cells apart. Takes 0.05 ms for eight cells. docs/repair.md. */
hl_status hl_best_place(const hl_star *star, void *memory, size_t room, hl_place *best);

/* Which points of a mesh may move: HL_STAYS never; HL_UNLESS_BOUNDARY anywhere, but on the boundary, by hl_boundary_points, only as
   `slides` and `boundary_distance` say; HL_FREED anywhere. */
typedef enum hl_moves { HL_STAYS = 0, HL_UNLESS_BOUNDARY = 1, HL_FREED = 2 } hl_moves;

typedef struct hl_untangled {
  size_t invalid_before, invalid_after;         /* cells */
  size_t below_before, below_after;             /* cells below the margin, or invalid */
  size_t moved_count, place_count, sweep_count; /* points elsewhere than before; best places that were sought */
  size_t too_many_count; /* points of cells below the margin that may move, but have more than HL_MOST_CELLS cells */
  double greatest_distance, mean_distance; /* of the points that were moved */
  double least_before, least_after;        /* relative minima; NaN where a cell has none */
  bool is_stopped;                         /* by `proceed` */
} hl_untangled;

/* Untangling: sweeps of best places over the points of a mesh, of each sweep the worst first, until all cells that a point which may move
   reaches have the margin or no point gains. No move lowers the least relative minimum of the cells around its point. */
typedef struct hl_untangling {
  double margin;        /* wanted: relative minimum at least this; from 0, for all that are valid, to 1 */
  const uint8_t *moves; /* hl_moves, one a point; null for HL_UNLESS_BOUNDARY everywhere */
  uint8_t *held; /* null, or one a point: gets 1 for those that may move and have a cell below the margin, else 0 */
  /* Points of planar parts of the boundary move in their plane, those on an edge between two planes along it: docs/repair.md (R16). */
  bool slides;
  double
      boundary_distance; /* boundary points move so far at most, all or, if they slide, these too; 0: no others than those that slide */
  size_t thread_count; /* 0 is 1 */
  /* Runs work(piece, 0) to work(piece, count - 1), each once, at once or one after another, and returns when all have ended. Null: one
     after another, here. */
  void (*run)(void *context, void (*work)(void *piece, size_t thread), void *piece, size_t count);
  /* Called before each piece of 128 stars at most with what was done so far, without distances and the least value; false ends the sweeps
     there. May be null. */
  bool (*proceed)(void *context, const hl_untangled *so_far);
  void *context;
} hl_untangling;

/* A star of more cells is left as it is. */
enum { HL_MOST_CELLS = 128 };

/* Bytes for a mesh: 44 a cell, 29 a point, and 0.8 MB a thread. */
size_t hl_untangle_room(size_t point_count, size_t cell_count, size_t thread_count);

/* 1 for each point of a face that no other cell has, or more than one other, else 0; `boundary` has one entry a point. The cells have
   indices; `memory` is as for hl_untangle with one thread. */
hl_status hl_boundary_points(const hl_cells *cells, void *memory, size_t room, uint8_t *boundary);

/* 1 for each cell whose nodes are numbered the other way round than is meant, else 0; `reversed` has one entry a cell. With nodes 0 to 3
   exchanged with 4 to 7 all cells that hang together by faces are numbered alike, and have a positive volume together. Only cells with a
   negative volume are marked, and none where numbering alike is not possible: docs/repair.md (R18). `memory` is as for
   hl_boundary_points. */
hl_status hl_reversed_cells(const hl_cells *cells, void *memory, size_t room, uint8_t *reversed);

/* Moves the points of cells with indices; `points` gets all coordinates, those of moved points new. The same bits for the same input on
   every machine and with any number of threads. `memory` is aligned for doubles and of hl_untangle_room bytes. A coordinate that is not
   finite is HL_NOT_FINITE. */
hl_status hl_untangle(const hl_cells *cells, const hl_untangling *wanted, void *memory, size_t room, double *points,
                      hl_untangled *result);

/* The limits that hl_untangle has for a point, while `memory` and its input are as it left them. False if the point stays. */
bool hl_untangled_limits(const void *memory, uint32_t point, hl_limits *limits);

/* Results as plain doubles in the order of the structs above, numbers and flags alike, lists cut to their counts: what
   crosses the WebAssembly boundary and what parity tests compare. Each returns how many were written. */
enum { HL_PACKED_CANDIDATE = 9, HL_PACKED_VOLUME_MINIMUM = 8, HL_PACKED_ROOT = 4 };
enum { HL_PACKED_FACE = HL_FACE_BERNSTEIN + 4 + HL_QUARTIC + 3 + HL_MAX_ROOTS * HL_PACKED_ROOT };
enum {
  HL_PACKED_REPORT = 3 + 2 * HL_PACKED_CANDIDATE + 1 + HL_PACKED_VOLUME_MINIMUM + HL_CHECKS + 3 + HL_BERNSTEIN +
      HL_FACES * HL_PACKED_FACE + 1 + HL_MAX_CANDIDATES * HL_PACKED_CANDIDATE + 2 + HL_VERTICES + 3,
  HL_PACKED_MINIMUM = HL_PACKED_CANDIDATE + 2,
  HL_PACKED_JACOBIAN = 17,
  HL_PACKED_PLACE = 13 + HL_MAX_HOLDS * 7,
  HL_PACKED_UNTANGLED = 13
};
size_t hl_pack_report(const hl_report *report, double packed[HL_PACKED_REPORT]);
size_t hl_pack_minimum(const hl_minimum *minimum, double packed[HL_PACKED_MINIMUM]);
size_t hl_pack_jacobian(const hl_jacobian *jacobian, double packed[HL_PACKED_JACOBIAN]);
size_t hl_pack_place(const hl_place *place, double packed[HL_PACKED_PLACE]);
size_t hl_pack_untangled(const hl_untangled *result, double packed[HL_PACKED_UNTANGLED]);

#if defined __GNUC__
#pragma GCC visibility pop
#endif

#ifdef __cplusplus
}
#endif

#endif
