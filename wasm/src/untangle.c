/* Sweeps of best places over a mesh: docs/repair.md 7. */
#include "bernstein.h"
#include "hexlens.h"
#include "scaling.h"
#include "topology.h"

#include <math.h>
#include <string.h>

/* A move counts as a gain, and calls for another sweep, from this part of the value on: sweeps end. */
#define LEAST_GAIN 0.01
enum { MOST_SWEEPS = 50 };

typedef struct mesh {
  const uint32_t *indices;
  size_t point_count, cell_count;
  double *points;
} mesh;

/* Lists in the caller's memory. The cells of point p are around[first[p]] to around[first[p + 1] - 1]. */
typedef struct lists {
  double *values; /* of cells: their relative minima, minus infinity where there is none */
  double *keys;   /* of points: the least of their cells */
  void *place_room;
  uint32_t *first, *around, *queue;
  uint8_t *fixed;
} lists;

static size_t whole(size_t bytes) { return (bytes + 7) / 8 * 8; }

size_t hl_untangle_room(size_t point_count, size_t cell_count) {
  return cell_count * sizeof(double) + point_count * sizeof(double) + whole(hl_best_place_room(HL_MOST_CELLS)) +
         whole((point_count + 1) * sizeof(uint32_t)) + whole(HL_VERTICES * cell_count * sizeof(uint32_t)) +
         whole(point_count * sizeof(uint32_t)) + whole(point_count);
}

static void *taken(char **next, size_t bytes) {
  void *start = *next;
  *next += whole(bytes);
  return start;
}

static lists lists_in(void *memory, const mesh *m) {
  char *next = memory;
  lists l;
  l.values = taken(&next, m->cell_count * sizeof(double));
  l.keys = taken(&next, m->point_count * sizeof(double));
  l.place_room = taken(&next, hl_best_place_room(HL_MOST_CELLS));
  l.first = taken(&next, (m->point_count + 1) * sizeof(uint32_t));
  l.around = taken(&next, HL_VERTICES * m->cell_count * sizeof(uint32_t));
  l.queue = taken(&next, m->point_count * sizeof(uint32_t));
  l.fixed = taken(&next, m->point_count);
  return l;
}

static hl_status read_mesh(const hl_cells *cells, size_t room, mesh *m) {
  if (!cells->indices) return HL_MISSING_LIST;
  if (cells->index_count % HL_VERTICES != 0 || cells->coordinate_count % 3 != 0) return HL_INCOMPLETE;
  *m = (mesh){cells->indices, cells->coordinate_count / 3, cells->index_count / HL_VERTICES, NULL};
  if (room < hl_untangle_room(m->point_count, m->cell_count)) return HL_NO_ROOM;
  for (size_t i = 0; i < cells->index_count; ++i)
    if (cells->indices[i] >= m->point_count) return HL_NO_SUCH_POINT;
  return HL_OK;
}

/* A cell that has a point more than once is in its list once. */
static bool is_first_of(const uint32_t *cell, int v) {
  for (int u = 0; u < v; ++u)
    if (cell[u] == cell[v]) return false;
  return true;
}

static void find_cells_around(const mesh *m, lists *l) {
  memset(l->first, 0, (m->point_count + 1) * sizeof(uint32_t));
  for (size_t c = 0; c < m->cell_count; ++c)
    for (int v = 0; v < HL_VERTICES; ++v) {
      const uint32_t *cell = m->indices + HL_VERTICES * c;
      if (is_first_of(cell, v)) ++l->first[cell[v] + 1];
    }
  for (size_t p = 0; p < m->point_count; ++p) l->first[p + 1] += l->first[p];
  for (size_t c = m->cell_count; c-- > 0;)
    for (int v = 0; v < HL_VERTICES; ++v) {
      const uint32_t *cell = m->indices + HL_VERTICES * c;
      if (is_first_of(cell, v)) l->around[--l->first[cell[v] + 1]] = (uint32_t)c;
    }
  /* Each entry is now the beginning of its point's list, one place too high. */
  memmove(l->first, l->first + 1, m->point_count * sizeof(uint32_t));
  l->first[m->point_count] = 0;
  for (size_t c = 0; c < m->cell_count; ++c)
    for (int v = 0; v < HL_VERTICES; ++v) l->first[m->point_count] += is_first_of(m->indices + HL_VERTICES * c, v);
}

/* The vertices of a face in no order that matters. */
static void face_points(const uint32_t *cell, int face, uint32_t points[4]) {
  for (int v = 0, n = 0; v < HL_VERTICES; ++v)
    if (vertex_reference[v][face_table[face].axis] == face_table[face].side) points[n++] = cell[v];
}

static bool has_all(const uint32_t *cell, const uint32_t points[4]) {
  for (int i = 0; i < 4; ++i) {
    bool is_found = false;
    for (int v = 0; v < HL_VERTICES; ++v) is_found = is_found || cell[v] == points[i];
    if (!is_found) return false;
  }
  return true;
}

/* A face is inside if exactly one other cell has its four points. */
static void mark_boundary(const mesh *m, const lists *l, uint8_t *boundary) {
  memset(boundary, 0, m->point_count);
  for (size_t c = 0; c < m->cell_count; ++c)
    for (int f = 0; f < HL_FACES; ++f) {
      uint32_t points[4];
      int others = 0;
      face_points(m->indices + HL_VERTICES * c, f, points);
      for (uint32_t i = l->first[points[0]]; i < l->first[points[0] + 1]; ++i)
        others += l->around[i] != c && has_all(m->indices + HL_VERTICES * l->around[i], points);
      for (int v = 0; v < 4 && others != 1; ++v) boundary[points[v]] = 1;
    }
}

hl_status hl_boundary_points(const hl_cells *cells, void *memory, size_t room, uint8_t *boundary) {
  mesh m;
  const hl_status status = read_mesh(cells, room, &m);
  if (status != HL_OK) return status;
  lists l = lists_in(memory, &m);
  find_cells_around(&m, &l);
  mark_boundary(&m, &l, boundary);
  return HL_OK;
}

/* Relative minima of cells by their indices. */
static void find_values(const mesh *m, const uint32_t *indices, size_t count, double *values, uint8_t *verdicts) {
  const hl_cells cells = {m->points, 3 * m->point_count, indices, HL_VERTICES * count};
  hl_batch batch = {.verdicts = verdicts, .relative_minima = values};
  hl_classify(&cells, &batch);
  for (size_t c = 0; c < count; ++c)
    if (values[c] != values[c]) values[c] = -INFINITY;
}

enum { PIECE = 1024 };

static void find_all_values(const mesh *m, double *values) {
  uint8_t verdicts[PIECE];
  for (size_t c = 0; c < m->cell_count; c += PIECE)
    find_values(m, m->indices + HL_VERTICES * c, m->cell_count - c < PIECE ? m->cell_count - c : PIECE, values + c,
                verdicts);
}

static double least_around(const lists *l, uint32_t p) {
  double least = INFINITY;
  for (uint32_t i = l->first[p]; i < l->first[p + 1]; ++i) least = smaller(least, l->values[l->around[i]]);
  return least;
}

/* A margin of 0 asks for what is positive. */
static bool is_below(double value, double margin) { return !(value >= margin && value > 0); }

/* Comes later in a sweep: the better, or of two as good the greater index. */
static bool is_later(const lists *l, uint32_t a, uint32_t b) {
  return l->keys[a] != l->keys[b] ? l->keys[a] > l->keys[b] : a > b;
}

/* The heap's entry at `at` goes down to its place. */
static void sift(const lists *l, size_t at, size_t count) {
  for (size_t child; (child = 2 * at + 1) < count; at = child) {
    if (child + 1 < count && is_later(l, l->queue[child + 1], l->queue[child])) ++child;
    if (!is_later(l, l->queue[child], l->queue[at])) return;
    const uint32_t p = l->queue[at];
    l->queue[at] = l->queue[child];
    l->queue[child] = p;
  }
}

/* Free vertices of cells below the margin, the worst first (heapsort). */
static size_t fill_queue(const mesh *m, const lists *l, double margin, hl_untangled *result) {
  size_t count = 0;
  result->too_many_count = 0;
  for (uint32_t p = 0; p < m->point_count; ++p) {
    if (l->fixed[p] || l->first[p] == l->first[p + 1]) continue;
    l->keys[p] = least_around(l, p);
    if (!is_below(l->keys[p], margin)) continue;
    if (l->first[p + 1] - l->first[p] > HL_MOST_CELLS) ++result->too_many_count;
    else l->queue[count++] = p;
  }
  for (size_t at = count / 2; at-- > 0;) sift(l, at, count);
  for (size_t end = count; end-- > 1;) {
    const uint32_t p = l->queue[0];
    l->queue[0] = l->queue[end];
    l->queue[end] = p;
    sift(l, 0, end);
  }
  return count;
}

static size_t count_below(const double *values, size_t count, double margin) {
  size_t below = 0;
  for (size_t c = 0; c < count; ++c) below += is_below(values[c], margin);
  return below;
}

/* The cells around a point with what they have become. */
typedef struct neighbourhood {
  uint32_t indices[HL_VERTICES * HL_MOST_CELLS];
  size_t count;
  double before[HL_MOST_CELLS], after[HL_MOST_CELLS];
} neighbourhood;

/* Moves the point unless more cells would be below the margin or the least of them lower. True if it has moved. */
static bool is_taken_to(const mesh *m, uint32_t p, const double place[3], double margin, neighbourhood *n) {
  uint8_t verdicts[HL_MOST_CELLS];
  double old[3];
  memcpy(old, m->points + 3 * p, sizeof old);
  memcpy(m->points + 3 * p, place, sizeof old);
  find_values(m, n->indices, n->count, n->after, verdicts);
  if (least_of(n->after, (int)n->count) >= least_of(n->before, (int)n->count) &&
      count_below(n->after, n->count, margin) <= count_below(n->before, n->count, margin))
    return true;
  memcpy(m->points + 3 * p, old, sizeof old);
  return false;
}

/* True if fewer cells are below the margin, or the least value has risen by what counts. */
static bool is_gain(const neighbourhood *n, double margin) {
  if (count_below(n->after, n->count, margin) < count_below(n->before, n->count, margin)) return true;
  const double before = least_of(n->before, (int)n->count), after = least_of(n->after, (int)n->count);
  return before == -INFINITY ? after > before : after - before > LEAST_GAIN * fabs(before);
}

/* Moves a point to its best place. Where one point of a cell alone holds the value down, which no place lifts, the place that is best
   for the other cells comes next. True if that is a gain. */
static bool improve(const mesh *m, const lists *l, uint32_t p, double margin, hl_untangled *result) {
  const uint32_t *around = l->around + l->first[p];
  neighbourhood n = {.count = l->first[p + 1] - l->first[p]};
  uint32_t left[HL_VERTICES * HL_MOST_CELLS];
  for (size_t c = 0; c < n.count; ++c) {
    memcpy(n.indices + HL_VERTICES * c, m->indices + HL_VERTICES * around[c], HL_VERTICES * sizeof *n.indices);
    n.before[c] = l->values[around[c]];
  }
  memcpy(left, n.indices, sizeof left);
  for (size_t count = n.count; count > 0; --count) {
    const hl_star star = {{m->points, 3 * m->point_count, left, HL_VERTICES * count}, NULL, p};
    hl_place place;
    ++result->place_count;
    if (hl_best_place(&star, l->place_room, hl_best_place_room(HL_MOST_CELLS), &place) != HL_OK) return false;
    if (place.is_moved && is_taken_to(m, p, place.position, margin, &n)) {
      for (size_t c = 0; c < n.count; ++c) l->values[around[c]] = n.after[c];
      if (is_gain(&n, margin)) return true;
      memcpy(n.before, n.after, sizeof n.before);
    }
    if (place.measure != HL_BY_SCALE || place.hold_count != 1 || place.holds[0].cell == HL_BOX_SIDE) return false;
    const size_t held = place.holds[0].cell;
    memmove(left + HL_VERTICES * held, left + HL_VERTICES * (held + 1),
            HL_VERTICES * (count - held - 1) * sizeof *left);
  }
  return false;
}

static void sweep_all(const mesh *m, const lists *l, const hl_untangling *wanted, hl_untangled *result) {
  for (bool is_gained = true; is_gained && result->sweep_count < MOST_SWEEPS; ++result->sweep_count) {
    const size_t count = fill_queue(m, l, wanted->margin, result);
    is_gained = false;
    for (size_t i = 0; i < count; ++i) {
      if (!is_below(least_around(l, l->queue[i]), wanted->margin)) continue;
      if (wanted->proceed && !wanted->proceed(wanted->context, result->place_count)) {
        result->is_stopped = true;
        return;
      }
      if (improve(m, l, l->queue[i], wanted->margin, result)) is_gained = true;
    }
    if (count == 0) return;
  }
}

static void count_cells(const mesh *m, const lists *l, double margin, size_t *invalid, size_t *below, double *least) {
  *invalid = 0;
  *below = count_below(l->values, m->cell_count, margin);
  *least = INFINITY;
  for (size_t c = 0; c < m->cell_count; ++c) {
    *invalid += !(l->values[c] > 0);
    *least = smaller(*least, l->values[c]);
  }
  if (*least == -INFINITY || *least == INFINITY) *least = NAN;
}

static void measure_moves(const mesh *m, const double *given, hl_untangled *result) {
  double sum = 0;
  for (size_t p = 0; p < m->point_count; ++p) {
    const double *from = given + 3 * p, *to = m->points + 3 * p;
    if (memcmp(from, to, 3 * sizeof *from) == 0) continue;
    const double way[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]}, distance = sqrt(dot(way, way));
    ++result->moved_count;
    sum += distance;
    result->greatest_distance = larger(result->greatest_distance, distance);
  }
  if (result->moved_count > 0) result->mean_distance = sum / (double)result->moved_count;
}

hl_status hl_untangle(const hl_cells *cells, const hl_untangling *wanted, void *memory, size_t room, double *points,
                      hl_untangled *result) {
  mesh m;
  const hl_status status = read_mesh(cells, room, &m);
  if (status != HL_OK) return status;
  for (size_t i = 0; i < cells->coordinate_count; ++i)
    if (!all_finite(cells->coordinates + i, 1)) return HL_NOT_FINITE;
  m.points = points;
  memcpy(points, cells->coordinates, cells->coordinate_count * sizeof *points);
  lists l = lists_in(memory, &m);
  find_cells_around(&m, &l);
  if (wanted->fixed) memcpy(l.fixed, wanted->fixed, m.point_count);
  else mark_boundary(&m, &l, l.fixed);
  find_all_values(&m, l.values);
  *result = (hl_untangled){.sweep_count = 0};
  count_cells(&m, &l, wanted->margin, &result->invalid_before, &result->below_before, &result->least_before);
  sweep_all(&m, &l, wanted, result);
  count_cells(&m, &l, wanted->margin, &result->invalid_after, &result->below_after, &result->least_after);
  measure_moves(&m, cells->coordinates, result);
  return HL_OK;
}
