/* Sweeps of best places over a mesh: docs/repair.md 7. */
#include "untangle.h"
#include "bernstein.h"
#include "report.h"
#include "reversed.h"
#include "scaling.h"
#include "slide.h"

#include <math.h>
#include <string.h>

/* A move counts as a gain, and calls for another sweep, from this part of the value on: sweeps end. */
#define LEAST_GAIN 0.01

/* The stars of a piece are divided among the threads; before each piece `proceed` is asked. */
enum { MOST_SWEEPS = 50, STARS_A_PIECE = 128 };

typedef struct lists {
  double *values; /* of cells: their relative minima, minus infinity where there is none */
  double *keys;   /* of points: the least of their cells */
  char *place_rooms;
  uint32_t *sorted;      /* points of the sweep, the worst first */
  uint32_t *levels;      /* of these, in their order */
  uint32_t *queue;       /* the same points by levels */
  uint32_t *ends;        /* of levels in the queue */
  uint32_t *cell_levels; /* the level of the last point that the sweep has in a cell */
  uint8_t *may_move;     /* a freedom */
} lists;

typedef enum freedom { STAYS, IS_FREE, IS_LIMITED } freedom;

/* What became of a star. */
typedef struct outcome {
  size_t place_count;
  ptrdiff_t below_change, invalid_change;
  bool is_gain;
} outcome;

struct untangling {
  mesh mesh;
  lists lists;
  hl_untangling wanted;
  const double *given;
  hl_untangled result;
  size_t queue_count, level, at; /* the next star is queue[at], of this level */
  bool is_gained, is_done;
  size_t piece_count;
  outcome outcomes[STARS_A_PIECE];
};

static size_t whole(size_t bytes) { return (bytes + 7) / 8 * 8; }

static size_t threads_of(size_t thread_count) { return thread_count > 0 ? thread_count : 1; }

size_t hl_untangle_room(size_t point_count, size_t cell_count, size_t thread_count) {
  return whole(sizeof(untangling)) + (cell_count + point_count) * sizeof(double) +
         threads_of(thread_count) * whole(hl_best_place_room(HL_MOST_CELLS)) +
         2 * whole((point_count + 1) * sizeof(uint32_t)) + 3 * whole(point_count * sizeof(uint32_t)) +
         whole(HL_VERTICES * cell_count * sizeof(uint32_t)) + whole(cell_count * sizeof(uint32_t)) + whole(point_count);
}

static void *taken(char **next, size_t bytes) {
  void *start = *next;
  *next += whole(bytes);
  return start;
}

static void place_lists(void *memory, size_t thread_count, mesh *m, lists *l) {
  char *next = (char *)memory + whole(sizeof(untangling));
  l->values = taken(&next, m->cell_count * sizeof(double));
  l->keys = taken(&next, m->point_count * sizeof(double));
  l->place_rooms = taken(&next, threads_of(thread_count) * whole(hl_best_place_room(HL_MOST_CELLS)));
  m->first = taken(&next, (m->point_count + 1) * sizeof(uint32_t));
  l->ends = taken(&next, (m->point_count + 1) * sizeof(uint32_t));
  l->sorted = taken(&next, m->point_count * sizeof(uint32_t));
  l->levels = taken(&next, m->point_count * sizeof(uint32_t));
  l->queue = taken(&next, m->point_count * sizeof(uint32_t));
  m->around = taken(&next, HL_VERTICES * m->cell_count * sizeof(uint32_t));
  l->cell_levels = taken(&next, m->cell_count * sizeof(uint32_t));
  l->may_move = taken(&next, m->point_count);
}

static hl_status open_mesh(const hl_cells *cells, void *memory, size_t room, size_t thread_count, mesh *m, lists *l) {
  const hl_status status = read_mesh(cells, m);
  if (status != HL_OK) return status;
  if (room < hl_untangle_room(m->point_count, m->cell_count, thread_count)) return HL_NO_ROOM;
  place_lists(memory, thread_count, m, l);
  find_cells_around(m);
  return HL_OK;
}

hl_status hl_boundary_points(const hl_cells *cells, void *memory, size_t room, uint8_t *boundary) {
  mesh m;
  lists l;
  const hl_status status = open_mesh(cells, memory, room, 1, &m, &l);
  if (status == HL_OK) mark_boundary(&m, boundary);
  return status;
}

hl_status hl_reversed_cells(const hl_cells *cells, void *memory, size_t room, uint8_t *reversed) {
  mesh m;
  lists l;
  const hl_status status = open_mesh(cells, memory, room, 1, &m, &l);
  if (status == HL_OK) find_reversed(&m, cells->coordinates, l.values, l.cell_levels, reversed);
  return status;
}

/* The relative minimum of a cell, as in hl_report; minus infinity where there is none. */
static double value_of(const mesh *m, size_t c) {
  double vertices[HL_COORDINATES];
  hl_minimum minimum;
  for (int v = 0; v < HL_VERTICES; ++v)
    memcpy(vertices + 3 * v, m->points + 3 * (size_t)m->indices[HL_VERTICES * c + (size_t)v], 3 * sizeof *vertices);
  hl_boundary_minimum(vertices, HL_ROOTS_B, &minimum);
  const scaled_double volume = find_volume(vertices);
  const double value = relative_minimum(minimum.minimizer.value, minimum.exponent, volume.mantissa, volume.exponent);
  return value == value ? value : -INFINITY;
}

static double least_around(const untangling *u, uint32_t p) {
  const mesh *m = &u->mesh;
  double least = INFINITY;
  for (uint32_t i = m->first[p]; i < m->first[p + 1]; ++i) least = smaller(least, u->lists.values[m->around[i]]);
  return least;
}

static size_t cells_around(const mesh *m, uint32_t p) { return m->first[p + 1] - m->first[p]; }

/* A margin of 0 asks for what is positive. */
static bool is_below(double value, double margin) { return !(value >= margin && value > 0); }

static size_t count_below(const double *values, size_t count, double margin) {
  size_t below = 0;
  for (size_t c = 0; c < count; ++c) below += is_below(values[c], margin);
  return below;
}

static size_t count_invalid(const double *values, size_t count) { return count_below(values, count, 0); }

/* Comes later in a sweep: the better, or of two as good the greater index. */
static bool is_later(const lists *l, uint32_t a, uint32_t b) {
  return l->keys[a] != l->keys[b] ? l->keys[a] > l->keys[b] : a > b;
}

/* The heap's entry at `at` goes down to its place. */
static void sift(const lists *l, size_t at, size_t count) {
  for (size_t child; (child = 2 * at + 1) < count; at = child) {
    if (child + 1 < count && is_later(l, l->sorted[child + 1], l->sorted[child])) ++child;
    if (!is_later(l, l->sorted[child], l->sorted[at])) return;
    const uint32_t p = l->sorted[at];
    l->sorted[at] = l->sorted[child];
    l->sorted[child] = p;
  }
}

/* Points that may move, of cells below the margin, the worst first (heapsort). */
static size_t sort_stars(untangling *u) {
  const mesh *m = &u->mesh;
  const lists *l = &u->lists;
  size_t count = 0;
  u->result.too_many_count = 0;
  for (uint32_t p = 0; p < m->point_count; ++p) {
    if (!l->may_move[p] || cells_around(m, p) == 0) continue;
    l->keys[p] = least_around(u, p);
    if (!is_below(l->keys[p], u->wanted.margin)) continue;
    if (cells_around(m, p) > HL_MOST_CELLS) ++u->result.too_many_count;
    else l->sorted[count++] = p;
  }
  for (size_t at = count / 2; at-- > 0;) sift(l, at, count);
  for (size_t end = count; end-- > 1;) {
    const uint32_t p = l->sorted[0];
    l->sorted[0] = l->sorted[end];
    l->sorted[end] = p;
    sift(l, 0, end);
  }
  return count;
}

/* A point's level is above that of each earlier point with which it has a cell in common. So points of one level have none, and what
   comes of the points level by level is what comes of them one by one. */
static void fill_queue(untangling *u) {
  const mesh *m = &u->mesh;
  const lists *l = &u->lists;
  const size_t count = sort_stars(u);
  memset(l->cell_levels, 0, m->cell_count * sizeof *l->cell_levels);
  memset(l->ends, 0, (count + 1) * sizeof *l->ends);
  for (size_t n = 0; n < count; ++n) {
    const uint32_t p = l->sorted[n];
    uint32_t level = 0;
    for (uint32_t i = m->first[p]; i < m->first[p + 1]; ++i)
      if (l->cell_levels[m->around[i]] > level) level = l->cell_levels[m->around[i]];
    for (uint32_t i = m->first[p]; i < m->first[p + 1]; ++i) l->cell_levels[m->around[i]] = level + 1;
    l->levels[n] = level;
    ++l->ends[level + 1];
  }
  for (size_t level = 0; level < count; ++level) l->ends[level + 1] += l->ends[level];
  for (size_t n = 0; n < count; ++n) l->queue[l->ends[l->levels[n]]++] = l->sorted[n];
  u->queue_count = count;
  u->level = 0;
  u->at = 0;
}

/* The cells around a point with what they have become. */
typedef struct neighbourhood {
  const uint32_t *cells;
  size_t count;
  double before[HL_MOST_CELLS], after[HL_MOST_CELLS];
} neighbourhood;

/* Moves the point unless more cells would be below the margin or the least of them lower. True if it has moved. */
static bool is_taken_to(const mesh *m, uint32_t p, const double place[3], double margin, neighbourhood *n) {
  double old[3], *point = m->points + 3 * (size_t)p;
  memcpy(old, point, sizeof old);
  memcpy(point, place, sizeof old);
  for (size_t c = 0; c < n->count; ++c) n->after[c] = value_of(m, n->cells[c]);
  if (least_of(n->after, (int)n->count) >= least_of(n->before, (int)n->count) &&
      count_below(n->after, n->count, margin) <= count_below(n->before, n->count, margin))
    return true;
  memcpy(point, old, sizeof old);
  return false;
}

/* True if fewer cells are below the margin, or the least value has risen by what counts. */
static bool is_gain(const neighbourhood *n, double margin) {
  if (count_below(n->after, n->count, margin) < count_below(n->before, n->count, margin)) return true;
  const double before = least_of(n->before, (int)n->count), after = least_of(n->after, (int)n->count);
  return before == -INFINITY ? after > before : after - before > LEAST_GAIN * fabs(before);
}

static ptrdiff_t change(size_t before, size_t after) { return (ptrdiff_t)after - (ptrdiff_t)before; }

static void take_values(const untangling *u, const neighbourhood *n, outcome *found) {
  const double margin = u->wanted.margin;
  found->below_change += change(count_below(n->before, n->count, margin), count_below(n->after, n->count, margin));
  found->invalid_change += change(count_invalid(n->before, n->count), count_invalid(n->after, n->count));
  for (size_t c = 0; c < n->count; ++c) u->lists.values[n->cells[c]] = n->after[c];
}

/* Moves a point to its best place. Where one point of a cell alone holds the value down, which no place lifts, the place that is best
   for the other cells comes next. */
static outcome improve(const untangling *u, uint32_t p, void *place_room) {
  const mesh *m = &u->mesh;
  const double margin = u->wanted.margin;
  outcome found = {.is_gain = false};
  neighbourhood n = {.cells = m->around + m->first[p], .count = cells_around(m, p)};
  uint32_t left[HL_VERTICES * HL_MOST_CELLS];
  for (size_t c = 0; c < n.count; ++c) {
    memcpy(left + HL_VERTICES * c, m->indices + HL_VERTICES * (size_t)n.cells[c], HL_VERTICES * sizeof *left);
    n.before[c] = u->lists.values[n.cells[c]];
  }
  hl_limits limits;
  const bool is_limited = u->lists.may_move[p] == IS_LIMITED;
  if (is_limited) boundary_limits(m, u->given, &u->wanted, p, &limits);
  for (size_t count = n.count; count > 0; --count) {
    const hl_star star = {
        {m->points, 3 * m->point_count, left, HL_VERTICES * count}, NULL, p, is_limited ? &limits : NULL};
    hl_place place;
    ++found.place_count;
    if (hl_best_place(&star, place_room, hl_best_place_room(HL_MOST_CELLS), &place) != HL_OK) return found;
    if (place.is_moved && is_taken_to(m, p, place.position, margin, &n)) {
      take_values(u, &n, &found);
      found.is_gain = is_gain(&n, margin);
      if (found.is_gain) return found;
      memcpy(n.before, n.after, sizeof n.before);
    }
    if (place.measure != HL_BY_SCALE || place.hold_count != 1 || place.holds[0].cell == HL_BOX_SIDE) return found;
    const size_t held = place.holds[0].cell;
    memmove(left + HL_VERTICES * held, left + HL_VERTICES * (held + 1),
            HL_VERTICES * (count - held - 1) * sizeof *left);
  }
  return found;
}

/* The share of one thread in the piece. */
static void improve_share(void *piece, size_t thread) {
  untangling *u = piece;
  char *room = u->lists.place_rooms + thread * whole(hl_best_place_room(HL_MOST_CELLS));
  for (size_t i = thread; i < u->piece_count; i += threads_of(u->wanted.thread_count)) {
    const uint32_t p = u->lists.queue[u->at + i];
    u->outcomes[i] = (outcome){.is_gain = false};
    if (is_below(least_around(u, p), u->wanted.margin)) u->outcomes[i] = improve(u, p, room);
  }
}

static void improve_piece(untangling *u) {
  const size_t threads = threads_of(u->wanted.thread_count);
  if (u->wanted.run) u->wanted.run(u->wanted.context, improve_share, u, threads);
  else
    for (size_t thread = 0; thread < threads; ++thread) improve_share(u, thread);
  for (size_t i = 0; i < u->piece_count; ++i) {
    const outcome *found = &u->outcomes[i];
    u->result.place_count += found->place_count;
    u->result.below_after = (size_t)((ptrdiff_t)u->result.below_after + found->below_change);
    u->result.invalid_after = (size_t)((ptrdiff_t)u->result.invalid_after + found->invalid_change);
    u->is_gained = u->is_gained || found->is_gain;
  }
  u->at += u->piece_count;
}

static bool next_sweep(untangling *u) {
  if (!u->is_gained || u->result.sweep_count == MOST_SWEEPS) return false;
  fill_queue(u);
  u->is_gained = false;
  if (u->queue_count > 0) ++u->result.sweep_count;
  return u->queue_count > 0;
}

bool step_untangling(untangling *u) {
  if (u->is_done) return false;
  if (u->wanted.proceed && !u->wanted.proceed(u->wanted.context, &u->result)) {
    u->result.is_stopped = true;
    u->is_done = true;
    return false;
  }
  if (u->at == u->queue_count && !next_sweep(u)) {
    u->is_done = true;
    return false;
  }
  while (u->at == u->lists.ends[u->level]) ++u->level;
  const size_t left = u->lists.ends[u->level] - u->at;
  u->piece_count = left < STARS_A_PIECE ? left : STARS_A_PIECE;
  improve_piece(u);
  return true;
}

const hl_untangled *result_so_far(const untangling *u) { return &u->result; }

static double least_value(const untangling *u) {
  double least = INFINITY;
  for (size_t c = 0; c < u->mesh.cell_count; ++c) least = smaller(least, u->lists.values[c]);
  return least == -INFINITY || least == INFINITY ? NAN : least;
}

static void measure_moves(const untangling *u, hl_untangled *result) {
  double sum = 0;
  for (size_t p = 0; p < u->mesh.point_count; ++p) {
    const double *from = u->given + 3 * p, *to = u->mesh.points + 3 * p;
    if (memcmp(from, to, 3 * sizeof *from) == 0) continue;
    const double way[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]}, distance = sqrt(dot(way, way));
    ++result->moved_count;
    sum += distance;
    result->greatest_distance = larger(result->greatest_distance, distance);
  }
  if (result->moved_count > 0) result->mean_distance = sum / (double)result->moved_count;
}

static freedom freedom_of(const untangling *u, uint32_t p, bool is_boundary) {
  const hl_moves moves = u->wanted.moves ? (hl_moves)u->wanted.moves[p] : HL_UNLESS_BOUNDARY;
  if (moves == HL_STAYS) return STAYS;
  if (moves == HL_FREED || !is_boundary) return IS_FREE;
  hl_limits limits;
  return boundary_limits(&u->mesh, u->given, &u->wanted, p, &limits) ? IS_LIMITED : STAYS;
}

static void choose_points(untangling *u) {
  uint8_t *may_move = u->lists.may_move;
  mark_boundary(&u->mesh, may_move);
  for (uint32_t p = 0; p < u->mesh.point_count; ++p) may_move[p] = (uint8_t)freedom_of(u, p, may_move[p]);
}

bool hl_untangled_limits(const void *memory, uint32_t point, hl_limits *limits) {
  const untangling *u = memory;
  if (u->lists.may_move[point] == IS_LIMITED) return boundary_limits(&u->mesh, u->given, &u->wanted, point, limits);
  *limits = (hl_limits){.low = {-INFINITY, -INFINITY, -INFINITY}, .high = {INFINITY, INFINITY, INFINITY}};
  return u->lists.may_move[point] == IS_FREE;
}

hl_status begin_untangling(const hl_cells *cells, const hl_untangling *wanted, void *memory, size_t room,
                           double *points, untangling **started) {
  mesh m;
  lists l;
  *started = NULL;
  const hl_status status = open_mesh(cells, memory, room, wanted->thread_count, &m, &l);
  if (status != HL_OK) return status;
  for (size_t i = 0; i < cells->coordinate_count; ++i)
    if (!all_finite(cells->coordinates + i, 1)) return HL_NOT_FINITE;
  untangling *u = memory;
  *u = (untangling){.mesh = m, .lists = l, .wanted = *wanted, .given = cells->coordinates, .is_gained = true};
  u->mesh.points = points;
  memcpy(points, cells->coordinates, cells->coordinate_count * sizeof *points);
  choose_points(u);
  for (size_t c = 0; c < m.cell_count; ++c) l.values[c] = value_of(&u->mesh, c);
  hl_untangled *result = &u->result;
  result->invalid_before = result->invalid_after = count_invalid(l.values, m.cell_count);
  result->below_before = result->below_after = count_below(l.values, m.cell_count, wanted->margin);
  result->least_before = least_value(u);
  *started = u;
  return HL_OK;
}

void end_untangling(untangling *u, uint8_t *held, hl_untangled *result) {
  u->result.least_after = least_value(u);
  *result = u->result;
  measure_moves(u, result);
  for (uint32_t p = 0; p < u->mesh.point_count && held; ++p)
    held[p] = u->lists.may_move[p] != STAYS && cells_around(&u->mesh, p) > 0 &&
              is_below(least_around(u, p), u->wanted.margin);
}

hl_status hl_untangle(const hl_cells *cells, const hl_untangling *wanted, void *memory, size_t room, double *points,
                      hl_untangled *result) {
  untangling *u;
  const hl_status status = begin_untangling(cells, wanted, memory, room, points, &u);
  if (status != HL_OK) return status;
  while (step_untangling(u)) continue;
  end_untangling(u, wanted->held, result);
  return HL_OK;
}
