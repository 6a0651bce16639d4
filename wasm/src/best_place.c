/* The best place of a vertex: docs/repair.md. A level of the measure makes each point of the cells a half-space of places; the search
   goes by levels between what a place has reached and what no place can. */
#include "bernstein.h"
#include "candidates.h"
#include "face.h"
#include "filter.h"
#include "hexlens.h"
#include "nearest.h"
#include "report.h"
#include "scaling.h"
#include "star.h"
#include "topology.h"

#include <math.h>
#include <string.h>

/* (R11): of the value, and the least value that it is relative to. */
#define GAP 1e-6
#define LEAST_VALUE 0x1p-20
/* (R7): how far a level is from what is reached to what seems possible, and the part of the gap that a last level keeps below. */
#define REACH 0.98
#define LAST_REACH 0.9
/* (R12): a value below a level by less than this part of the greatest coefficient is at the level. */
#define VALUE_ERROR 0x1p-44
/* (R13): the part of its terms below which a gradient is rounding. */
#define GRADIENT_ERROR 0x1p-44
#define POINT_GRID 0x1p26

enum { BOX_SIDES = 6, CUTS_A_CELL = 40, MORE_CUTS = 64, MOST_ROUNDS = 128 };

/* jacdet at a point of a cell, as a function of the place. By its sign it is to be positive, whatever the level. */
typedef struct cut {
  affine jacdet;
  double point[3];
  size_t cell;
  bool is_by_sign;
} cut;

typedef struct search {
  const star_frame *frame;
  const star_cell *cells;
  size_t cell_count;
  cut *cuts;
  size_t cut_count, cut_room;
  half_spaces half_spaces;
  double *lengths; /* of the normals before they had length 1 */
  hl_measure measure;
  double lower, upper, best[3]; /* the place `best` reaches `lower`, no place is above `upper` */
  nearest_point proof;
  double proof_weights[MOST_SUPPORTS];
  int round_count;
} search;

static affine denominator(const search *s, const star_cell *cell) {
  return s->measure == HL_BY_VOLUME ? cell->volume : (affine){.constant = cell->scale};
}

static affine denominator_of(const search *s, const cut *row) {
  return row->is_by_sign ? (affine){.constant = 0} : denominator(s, &s->cells[row->cell]);
}

/* Row of the cut, (R5): jacdet at a boundary point whose coordinates are rounded to the grid. */
static void add_cut(search *s, size_t c, const double point[3], bool is_by_sign) {
  if (s->cut_count == s->cut_room) return;
  const star_cell *cell = &s->cells[c];
  cut *added = &s->cuts[s->cut_count++];
  double weights[3][3];
  *added = (cut){.cell = c, .is_by_sign = is_by_sign};
  for (int axis = 0; axis < 3; ++axis) {
    const double x = (double)(int32_t)(point[axis] * POINT_GRID + 0.5) / POINT_GRID;
    added->point[axis] = x;
    weights[axis][0] = (1 - x) * (1 - x);
    weights[axis][1] = 2 * x * (1 - x);
    weights[axis][2] = x * x;
  }
  for (int i = 0; i < HL_BERNSTEIN; ++i) {
    const double weight = weights[0][axis_digit(i, 0)] * weights[1][axis_digit(i, 1)] * weights[2][axis_digit(i, 2)];
    if (weight == 0) continue;
    for (int r = 0; r < 3; ++r) added->jacdet.gradient[r] += weight * cell->bernstein[i].gradient[r];
    added->jacdet.constant += weight * cell->bernstein[i].constant;
  }
}

static void put_half_space(half_spaces *h, const double normal[3], double offset) {
  h->x[h->count] = normal[0];
  h->y[h->count] = normal[1];
  h->w[h->count] = normal[2];
  h->offset[h->count++] = offset;
}

static double size_of(const affine *f) { return fabs(f->gradient[0]) + fabs(f->gradient[1]) + fabs(f->gradient[2]); }

/* (R6): the places where all cuts are at the level or above it. */
static void fill_half_spaces(search *s, double level) {
  half_spaces *h = &s->half_spaces;
  h->count = 0;
  for (size_t i = 0; i < s->cut_count; ++i) {
    const cut *row = &s->cuts[i];
    const affine below = denominator_of(s, row);
    double normal[3];
    for (int r = 0; r < 3; ++r) normal[r] = row->jacdet.gradient[r] - level * below.gradient[r];
    const double offset = level * below.constant - row->jacdet.constant, length = sqrt(dot(normal, normal));
    const double terms = size_of(&row->jacdet) + fabs(level) * size_of(&below);
    if (length <= GRADIENT_ERROR * terms) {
      /* The same at every place, in units of the scale. */
      s->lengths[i] = s->cells[row->cell].scale;
      put_half_space(h, (double[]){0, 0, 0}, offset / s->lengths[i]);
      continue;
    }
    s->lengths[i] = length;
    for (int r = 0; r < 3; ++r) normal[r] /= length;
    put_half_space(h, normal, offset / length);
  }
  for (int side = 0; side < BOX_SIDES; ++side) {
    const int a = side % 3;
    double normal[3] = {0, 0, 0};
    normal[a] = side < 3 ? 1 : -1;
    project(s->frame, normal);
    const double length = sqrt(dot(normal, normal)), offset = side < 3 ? s->frame->low[a] : -s->frame->high[a];
    const bool is_fixed = length <= GRADIENT_ERROR; /* the coordinate is the same at every place */
    s->lengths[h->count] = is_fixed ? 1 : length;
    for (int r = 0; r < 3; ++r) normal[r] = is_fixed ? 0 : normal[r] / length;
    put_half_space(h, normal, is_fixed ? 0 : offset / length);
  }
}

static bool is_cut(const search *s, size_t half_space) { return half_space < s->cut_count; }

/* No place reaches the level: what is above every place, and what the best place makes of it, (R9). */
static double take_proof(search *s, const nearest_point *none, double level) {
  double sum = 0, fall = 0, weights[MOST_SUPPORTS] = {0};
  for (int i = 0; i < none->support_count; ++i) {
    const size_t n = none->supports[i];
    weights[i] = none->weights[i] / s->lengths[n];
    fall += none->weights[i] * s->half_spaces.offset[n];
    if (!is_cut(s, n)) continue;
    const affine below = denominator_of(s, &s->cuts[n]);
    sum += weights[i] * affine_at(&below, s->best);
  }
  s->proof = *none;
  memcpy(s->proof_weights, weights, sizeof weights);
  double estimate = sum > 0 ? level - fall / sum : s->lower;
  if (!(estimate > s->lower)) estimate = s->lower;
  if (estimate > level) estimate = level;
  s->upper = s->measure == HL_BY_SCALE ? estimate : level;
  return estimate;
}

static void bernstein_at(const star_cell *cell, const double z[3], double bernstein[27]) {
  for (int i = 0; i < HL_BERNSTEIN; ++i) bernstein[i] = affine_at(&cell->bernstein[i], z);
}

/* Points of a cell are cuts where jacdet is below the level, or by sign where it is negative. */
typedef struct cutter {
  search *s;
  size_t cell;
  double limit;
  bool is_by_sign;
} cutter;

static void consider(const cutter *c, const hl_candidate *candidate) {
  if (candidate->value < c->limit) add_cut(c->s, c->cell, candidate->point, c->is_by_sign);
}

/* The level, less what rounding can take from a value. */
static double limit_of(const double bernstein[27], double level) {
  return level - VALUE_ERROR * greatest_magnitude(bernstein, HL_BERNSTEIN);
}

/* The least jacdet of a cell. Its vertices are left to the caller. */
static double least_jacdet(const cutter *c, const double bernstein[27]) {
  double least = bernstein[vertex_index(0)];
  hl_candidate candidate;
  for (int v = 1; v < HL_VERTICES; ++v) least = smaller(least, bernstein[vertex_index(v)]);
  for (int e = 0; e < HL_EDGES; ++e) {
    if (!edge_candidate(bernstein, e, larger(least, c->limit), &candidate)) continue;
    consider(c, &candidate);
    least = smaller(least, candidate.value);
  }
  for (int f = 0; f < HL_FACES; ++f) {
    double beta[HL_FACE_BERNSTEIN];
    face_bernstein(bernstein, f, beta);
    if (least_of(beta, HL_FACE_BERNSTEIN) >= least || !face_can_be_lower(beta, least)) continue;
    face_solution solution;
    find_kept_roots(beta, &solution);
    for (int r = 0; r < solution.root_count; ++r) {
      if (!(solution.values[r] < least)) continue;
      candidate = face_candidate(f, &solution, r);
      consider(c, &candidate);
      least = candidate.value;
    }
  }
  return least;
}

/* A volume that is not positive takes the sense from a level by volume, but jacdet is negative somewhere. */
static void cut_by_sign(search *s, size_t cell, const double z[3]) {
  double bernstein[27];
  bernstein_at(&s->cells[cell], z, bernstein);
  const cutter c = {s, cell, limit_of(bernstein, 0), true};
  for (int v = 0; v < HL_VERTICES; ++v) {
    const hl_candidate vertex = vertex_candidate(bernstein, v);
    consider(&c, &vertex);
  }
  least_jacdet(&c, bernstein);
}

/* The value of a place by the measure; by volume, minus infinity where a volume is not positive. A cell whose coefficients are above
   both the least value so far and the level has nothing to say. */
static double look_at(search *s, const double z[3], double level) {
  double value = INFINITY;
  ++s->round_count;
  for (size_t c = 0; c < s->cell_count; ++c) {
    const affine below = denominator(s, &s->cells[c]);
    const double size = affine_at(&below, z);
    if (!(size > 0)) {
      cut_by_sign(s, c, z);
      value = -INFINITY;
    }
    for (int v = 0; v < HL_VERTICES && value > -INFINITY; ++v)
      value = smaller(value, affine_at(&s->cells[c].bernstein[vertex_index(v)], z) / size);
  }
  for (size_t c = 0; c < s->cell_count && value > -INFINITY; ++c) {
    const affine below = denominator(s, &s->cells[c]);
    const double size = affine_at(&below, z);
    double bernstein[27];
    bernstein_at(&s->cells[c], z, bernstein);
    bernstein[CUBE_CENTRE] = bernstein[0];
    if (least_of(bernstein, HL_BERNSTEIN) >= larger(value, level) * size) continue;
    const cutter cut_below = {s, c, limit_of(bernstein, level * size), false};
    value = smaller(value, least_jacdet(&cut_below, bernstein) / size);
  }
  return value;
}

static double gap_of(const search *s) { return GAP * larger(fabs(s->lower), LEAST_VALUE); }

static bool is_open(const search *s) {
  return s->upper - s->lower > gap_of(s) && s->round_count < MOST_ROUNDS &&
         !(s->measure == HL_BY_SCALE && s->lower > 0);
}

/* (R7): where the gap has not been halved since the last round, the estimate is at least the middle. */
static double next_level(const search *s, double estimate, double last_gap) {
  if (s->upper - s->lower > 0.5 * last_gap) estimate = larger(estimate, 0.5 * (s->lower + s->upper));
  const double least = s->lower + LAST_REACH * gap_of(s), level = s->lower + REACH * (estimate - s->lower);
  return smaller(larger(level, least), s->upper);
}

static nearest_point nearest_at(search *s, double level) {
  fill_half_spaces(s, level);
  return find_nearest(&s->half_spaces);
}

static void prove(search *s, double level) {
  const nearest_point none = nearest_at(s, level);
  if (none.kind == NEAREST_NONE) take_proof(s, &none, level);
}

static void narrow(search *s) {
  double estimate = s->upper, last_gap = INFINITY;
  while (is_open(s)) {
    const double level = next_level(s, estimate, last_gap);
    const nearest_point nearest = nearest_at(s, level);
    if (nearest.kind == NEAREST_OPEN) return;
    if (nearest.kind == NEAREST_NONE) {
      estimate = take_proof(s, &nearest, level);
      continue;
    }
    const size_t before = s->cut_count;
    last_gap = s->upper - s->lower;
    const double value = look_at(s, nearest.z, level);
    if (value > s->lower) {
      s->lower = value;
      memcpy(s->best, nearest.z, sizeof s->best);
    } else if (s->cut_count == before) {
      return;
    }
    estimate = s->upper;
  }
}

/* The greatest value by scale that one cut alone allows in the box. */
static double upper_by_scale(const search *s) {
  double upper = INFINITY, reach = 0;
  for (int a = 0; a < 3; ++a) reach = larger(reach, larger(-s->frame->low[a], s->frame->high[a]));
  for (size_t i = 0; i < s->cut_count; ++i) {
    const affine *jacdet = &s->cuts[i].jacdet;
    upper = smaller(upper, (jacdet->constant + reach * size_of(jacdet)) / s->cells[s->cuts[i].cell].scale);
  }
  return upper;
}

/* By scale until a valid place is found, then by volume, where no value is above 1. */
static void find_best(search *s) {
  const double present[3] = {0, 0, 0};
  for (size_t c = 0; c < s->cell_count; ++c)
    for (int v = 0; v < HL_VERTICES; ++v) add_cut(s, c, vertex_point[v], false);
  s->measure = HL_BY_SCALE;
  s->upper = upper_by_scale(s);
  s->lower = look_at(s, present, s->upper);
  s->upper = larger(s->upper, s->lower) + gap_of(s); /* a level above what the cut allows, for the proof */
  prove(s, s->upper);
  narrow(s);
  if (!(s->lower > 0)) return;
  s->measure = HL_BY_VOLUME;
  s->proof.support_count = 0;
  s->upper = 1;
  s->lower = look_at(s, s->best, 1);
  narrow(s);
}

/* Least relative minimum and least value by scale, from the analysis of the cells. */
typedef struct analysis {
  double relative_minimum, by_scale;
  bool is_valid;
} analysis;

static double least_or_none(double x, double y) { return x != x || y != y ? NAN : smaller(x, y); }

static analysis analysis_of(const hl_star *star, const star_frame *frame, const search *s, const double place[3]) {
  analysis found = {INFINITY, INFINITY, true};
  for (size_t c = 0; c < s->cell_count; ++c) {
    double vertices[HL_COORDINATES];
    hl_minimum minimum;
    placed_cell(star, s->cells[c].number, place, vertices);
    turned_cell(frame, vertices);
    hl_boundary_minimum(vertices, HL_ROOTS_B, &minimum);
    const double jacdet = minimum.minimizer.value;
    const scaled_double volume = find_volume(vertices);
    const double relative = relative_minimum(jacdet, minimum.exponent, volume.mantissa, volume.exponent);
    const double by_scale = relative_minimum(jacdet, minimum.exponent, s->cells[c].scale, 3 * frame->exponent);
    if (!(jacdet > 0)) found.is_valid = false;
    found.relative_minimum = least_or_none(found.relative_minimum, relative);
    found.by_scale = smaller(found.by_scale, by_scale);
  }
  return found;
}

static bool is_better(const analysis *a, const analysis *b) {
  if (a->is_valid != b->is_valid) return a->is_valid;
  return a->is_valid ? a->relative_minimum > b->relative_minimum : a->by_scale > b->by_scale;
}

static void put_holds(const search *s, const star_frame *frame, hl_place *best) {
  double sum = 0;
  best->hold_count = s->proof.support_count;
  for (int i = 0; i < best->hold_count; ++i) {
    const size_t n = s->proof.supports[i];
    hl_hold *hold = &best->holds[i];
    if (is_cut(s, n)) {
      const cut *row = &s->cuts[n];
      const star_cell *cell = &s->cells[row->cell];
      *hold = (hl_hold){.cell = cell->number,
                        .weight = s->proof_weights[i] * cell->scale,
                        .scale = cell->scale,
                        .is_by_sign = row->is_by_sign};
      memcpy(hold->point, row->point, sizeof hold->point);
      sum += hold->weight;
    } else {
      const size_t side = (n - s->cut_count) % 3;
      *hold = (hl_hold){.cell = HL_BOX_SIDE, .weight = s->proof_weights[i], .scale = 1};
      hold->point[frame->axis[side]] = n - s->cut_count < 3 ? -frame->sign[side] : frame->sign[side];
    }
  }
  for (int i = 0; i < best->hold_count && sum > 0; ++i) best->holds[i].weight /= sum;
}

size_t hl_best_place_room(size_t cell_count) {
  const size_t cuts = (HL_VERTICES + CUTS_A_CELL) * cell_count + MORE_CUTS;
  return cell_count * sizeof(star_cell) + cuts * sizeof(cut) + 5 * (cuts + BOX_SIDES) * sizeof(double);
}

hl_status hl_best_place(const hl_star *star, void *memory, size_t room, hl_place *best) {
  const size_t count = star_cell_count(star);
  if (room < hl_best_place_room(count)) return HL_NO_ROOM;
  star_frame frame;
  star_cell *cells = memory;
  const hl_status status = read_star(star, &frame, cells);
  if (status != HL_OK) return status;
  search s = {.frame = &frame,
              .cells = cells,
              .cell_count = count,
              .cut_room = (HL_VERTICES + CUTS_A_CELL) * count + MORE_CUTS};
  s.cuts = (cut *)(cells + count);
  double *lists = (double *)(s.cuts + s.cut_room);
  const size_t each = s.cut_room + BOX_SIDES;
  s.half_spaces = (half_spaces){lists, lists + each, lists + 2 * each, lists + 3 * each, 0};
  s.lengths = lists + 4 * each;
  find_best(&s);

  const double present_z[3] = {0, 0, 0};
  double present_place[3];
  place_of(&frame, present_z, present_place);
  const analysis present = analysis_of(star, &frame, &s, present_place);
  place_of(&frame, s.best, best->position);
  analysis found = present;
  if (all_finite(best->position, 3)) found = analysis_of(star, &frame, &s, best->position);
  best->is_moved = is_better(&found, &present);
  if (!best->is_moved) {
    found = present;
    memcpy(best->position, present_place, sizeof present_place);
  }
  best->measure = s.measure;
  best->value = s.measure == HL_BY_VOLUME ? found.relative_minimum : found.by_scale;
  best->bound = larger(s.upper, best->value);
  best->is_closed = best->bound - best->value <= GAP * larger(fabs(best->value), LEAST_VALUE);
  best->relative_minimum = found.relative_minimum;
  best->present_relative_minimum = present.relative_minimum;
  best->unit_exponent = frame.exponent;
  put_holds(&s, &frame, best);
  best->round_count = s.round_count;
  return HL_OK;
}
