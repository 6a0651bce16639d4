/* A batch is its cells one by one, bit for bit, by every fast stage that this machine runs and without any; whatever lists are
   asked for, each has the same entries. */
#include "../../wasm/src/batch.h"
#include "../../wasm/src/bernstein.h"
#include "../../wasm/src/filter.h"
#include "../../wasm/src/report.h"
#include "check.h"
#include "hexlens.h"
#include "random.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* A cell is answered by every kernel in many batches: enough of them for the longest batch. */
enum { MANY = 300 + TIMES(2580), LONGEST = 33 };

/* The lists of hl_batch: where the pointer is, and how many bytes a cell has. */
enum {
  VERDICTS,
  STATUSES,
  IS_EXACT,
  CLASSES,
  ACCEPTED_BY,
  MINIMA,
  MINIMIZERS,
  CORNER_MINIMA,
  EXPONENTS,
  RELATIVE_MINIMA,
  VOLUMES,
  VOLUME_EXPONENTS,
  LISTS
};
static const struct {
  const char *name;
  size_t at, size;
} list_table[LISTS] = {{"verdicts", offsetof(hl_batch, verdicts), 1},
                       {"statuses", offsetof(hl_batch, statuses), 1},
                       {"is_exact", offsetof(hl_batch, is_exact), 1},
                       {"classes", offsetof(hl_batch, classes), 1},
                       {"accepted_by", offsetof(hl_batch, accepted_by), sizeof(uint16_t)},
                       {"minima", offsetof(hl_batch, minima), sizeof(double)},
                       {"minimizers", offsetof(hl_batch, minimizers), 3 * sizeof(double)},
                       {"corner_minima", offsetof(hl_batch, corner_minima), sizeof(double)},
                       {"exponents", offsetof(hl_batch, exponents), sizeof(int16_t)},
                       {"relative_minima", offsetof(hl_batch, relative_minima), sizeof(double)},
                       {"volumes", offsetof(hl_batch, volumes), sizeof(double)},
                       {"volume_exponents", offsetof(hl_batch, volume_exponents), sizeof(int16_t)}};

enum { ALL_LISTS = (1 << LISTS) - 1, ROOM = 16, UNTOUCHED = 0x55 };

static bool has(unsigned lists, int list) { return lists >> list & 1; }

static bool asks_for_minima(unsigned lists) {
  return has(lists, MINIMA) || has(lists, MINIMIZERS) || has(lists, CORNER_MINIMA) || has(lists, EXPONENTS) ||
         has(lists, RELATIVE_MINIMA);
}

static bool is_complete(unsigned lists) {
  return has(lists, VERDICTS) && (has(lists, EXPONENTS) || !(has(lists, MINIMA) || has(lists, CORNER_MINIMA))) &&
         (has(lists, VOLUME_EXPONENTS) || !has(lists, VOLUMES));
}

/* Memory for the lists that are asked for, with room behind them that must stay as it is. */
typedef struct memory {
  unsigned char *lists[LISTS];
  size_t count;
} memory;

static memory new_memory(unsigned lists, size_t count, hl_batch *batch) {
  memory m = {{NULL}, count};
  *batch = (hl_batch){0};
  for (int i = 0; i < LISTS; ++i) {
    if (!has(lists, i)) continue;
    m.lists[i] = malloc(count * list_table[i].size + ROOM);
    memset(m.lists[i], UNTOUCHED, count * list_table[i].size + ROOM);
    void *list = m.lists[i];
    memcpy((char *)batch + list_table[i].at, &list, sizeof list);
  }
  return m;
}

static bool is_untouched(const memory *m, int list, size_t from) {
  const size_t end = m->count * list_table[list].size + ROOM;
  for (size_t i = from; i < end; ++i)
    if (m->lists[list][i] != UNTOUCHED) return false;
  return true;
}

/* Nothing is written behind the lists. */
static void check_ends_and_free(memory *m, const char *name) {
  for (int i = 0; i < LISTS; ++i) {
    if (!m->lists[i]) continue;
    CHECK(is_untouched(m, i, m->count * list_table[i].size), "%s: written behind %zu %s", name, m->count,
          list_table[i].name);
    free(m->lists[i]);
  }
}

static void read_entry(const memory *m, int list, size_t cell, void *entry) {
  memcpy(entry, m->lists[list] + cell * list_table[list].size, list_table[list].size);
}

static double double_in(const memory *m, int list, size_t cell) {
  double x;
  read_entry(m, list, cell, &x);
  return x;
}

static int exponent_in(const memory *m, int list, size_t cell) {
  int16_t x;
  read_entry(m, list, cell, &x);
  return x;
}

/* All there is to compare of one cell: what hl_decide, hl_boundary_minimum and hl_analyze say of it. */
typedef struct answer {
  hl_status status;
  hl_verdict verdict;
  bool is_decided_exactly; /* the verdict, by integers */
  hl_minimum minimum;
  hl_class element_class;
  unsigned accepted_by;
  double corner, relative_minimum, volume;
  int corner_exponent, volume_exponent;
} answer;

static int all_kernels(const lane_kernels *list[5]) {
  int count = usable_lanes(list);
  list[count] = NULL;
  return count + 1;
}

static const char *name_of(const lane_kernels *kernels) { return kernels ? kernels->name : "scalar"; }

/* Sixteen of every kind in a row, so that there are blocks of all alike: the paper's elements, small integers with touching minima
   and flat ones, other sizes and places, thin, sheared and collapsed ones, ones with a corner below the doubles, any bits at all.
   Never a NaN or an infinity. */
static void hard_hexahedron(random_stream *stream, int n, double v[24]) {
  enum { ROW = 16, KINDS = 9 };
  const int kind = n / ROW % KINDS, k = n % ROW + n / (ROW * KINDS) * ROW; /* the kth of its kind */
  random_hexahedron(stream, 0.1 * (k % 21), v);
  double scales[3], sheared[9];
  for (int axis = 0; axis < 3; ++axis) scales[axis] = ldexp(1, (int)(random_unit(stream) * 80) - 40);
  for (int i = 0; i < 9; ++i) sheared[i] = random_normal(stream);
  for (int axis = 0; axis < 3; ++axis)
    sheared[6 + axis] = sheared[axis] + 2 * sheared[3 + axis] + ldexp(sheared[6 + axis], -3 - k % 20);
  for (int i = 0; i < 24; ++i) {
    const double *reference = unit_cube + i / 3 * 3;
    switch (kind) {
    case 0: break;
    case 1: v[i] = floor(v[i] * 2 + 0.5) / 2; break;
    case 2: v[i] = ldexp(v[i], k % 2 ? -300 : k % 600 - 300); break;
    case 3: v[i] = v[i] * scales[i % 3] + 1000 * scales[(i + 1) % 3]; break;
    case 4: v[i] = i % 3 == 2 ? v[i] * 0x1p-30 : floor(v[i] * 8) / 8; break;
    case 5: v[i] = i >= 12 && k % 3 == 0 ? v[i - 12] : floor(v[i] * 4) * 0x1p-340; break;
    case 6:
      v[i] = reference[0] * sheared[i % 3] + reference[1] * sheared[3 + i % 3] + reference[2] * sheared[6 + i % 3];
      break;
    case 7: v[i] = i == k % 24 ? ldexp(k / 24 % 2 ? 1 : -1, -560 - k % 50) : unit_cube[i] * 0x1p-248; break;
    default: {
      uint64_t bits = random_bits(stream);
      if ((bits >> 52 & 0x7ff) == 0x7ff) bits ^= (uint64_t)1 << 62;
      memcpy(&v[i], &bits, sizeof bits);
    }
    }
  }
}

static answer alone(const double v[24]) {
  static hl_report report;
  answer a = {.status = hl_analyze(v, &report)};
  if (a.status != HL_OK) return a;
  hl_decide(v, &a.verdict);
  hl_boundary_minimum(v, HL_ROOTS_B, &a.minimum);
  CHECK(a.verdict == report.verdict, "decide says %d, analyze %d", a.verdict, report.verdict);
  CHECK(a.minimum.is_exact == report.is_exact, "the minimum is exact: %d, the report: %d", a.minimum.is_exact,
        report.is_exact);
  CHECK(!memcmp(report.minimizer.point, a.minimum.minimizer.point, sizeof report.minimizer.point), "two minimizers");
  edge_vectors edges;
  double bernstein[HL_BERNSTEIN];
  hl_verdict by_filter;
  scaled_edge_vectors(v, &edges);
  jacdet_bernstein(&edges, bernstein);
  a.is_decided_exactly = !is_settled_by_filter(bernstein, &by_filter);
  a.element_class = report.element_class;
  for (int c = 0; c < HL_CHECKS; ++c) a.accepted_by |= (unsigned)(report.checks[c] > 0) << c;
  a.corner = report.corner_minimum;
  a.corner_exponent = report.exponent;
  a.relative_minimum = report.relative_minimum;
  a.volume = report.volume;
  a.volume_exponent = report.volume_exponent;
  return a;
}

static bool same(double x, double y) { return memcmp(&x, &y, sizeof x) == 0 || (isnan(x) && isnan(y)); }

/* x * 2^e = y * 2^f. */
static bool same_number(double x, int e, double y, int f) {
  int ex, ey;
  const double mx = frexp(x, &ex), my = frexp(y, &ey);
  return same(mx, my) && (mx == 0 || ex + e == ey + f);
}

/* The least or the greatest normal double stands for what the unit of a report or of a cell has no room for. */
static bool is_at_an_end(double x) { return fabs(x) == DBL_MIN || fabs(x) == DBL_MAX; }

static void check_unanswered(const char *name, const memory *m, size_t c, hl_status status) {
  for (int i = 0; i < LISTS; ++i) {
    if (!m->lists[i]) continue;
    if (i == MINIMIZERS) {
      double point[3];
      read_entry(m, i, c, point);
      CHECK(isnan(point[0]) && isnan(point[1]) && isnan(point[2]), "%s: cell %zu: minimizer", name, c);
    } else if (list_table[i].size == sizeof(double)) {
      CHECK(isnan(double_in(m, i, c)), "%s: cell %zu: %s", name, c, list_table[i].name);
    } else {
      uint16_t entry = 0;
      read_entry(m, i, c, &entry);
      CHECK(entry == (i == STATUSES ? status : 0), "%s: cell %zu: %s is %d", name, c, list_table[i].name, entry);
    }
  }
}

static void check_cell(const char *name, unsigned lists, const memory *m, size_t c, const answer *a) {
  if (a->status != HL_OK) {
    check_unanswered(name, m, c, a->status);
    return;
  }
  const int expected[4] = {(int)a->verdict, HL_OK, asks_for_minima(lists) ? a->minimum.is_exact : a->is_decided_exactly,
                           (int)a->element_class};
  for (int i = VERDICTS; i <= CLASSES; ++i)
    if (m->lists[i])
      CHECK(m->lists[i][c] == expected[i], "%s, lists %x: cell %zu: %s is %d, alone %d", name, lists, c,
            list_table[i].name, m->lists[i][c], expected[i]);
  if (m->lists[ACCEPTED_BY]) {
    uint16_t bits;
    read_entry(m, ACCEPTED_BY, c, &bits);
    CHECK(bits == a->accepted_by, "%s: cell %zu: accepted by %x, alone %x", name, c, bits, a->accepted_by);
  }
  const int exponent = m->lists[EXPONENTS] ? exponent_in(m, EXPONENTS, c) : 0;
  if (m->lists[MINIMA])
    CHECK(same_number(double_in(m, MINIMA, c), exponent, a->minimum.minimizer.value, a->minimum.exponent),
          "%s: cell %zu: minimum %a 2^%d, alone %a 2^%d", name, c, double_in(m, MINIMA, c), exponent,
          a->minimum.minimizer.value, a->minimum.exponent);
  if (m->lists[MINIMIZERS]) {
    double point[3];
    read_entry(m, MINIMIZERS, c, point);
    CHECK(!memcmp(point, a->minimum.minimizer.point, sizeof point), "%s: cell %zu: minimizer", name, c);
  }
  if (m->lists[CORNER_MINIMA]) {
    const double corner = double_in(m, CORNER_MINIMA, c);
    CHECK(same_number(corner, exponent, a->corner, a->corner_exponent) ||
              ((is_at_an_end(corner) || is_at_an_end(a->corner)) && signbit(corner) == signbit(a->corner)),
          "%s: cell %zu: corner %a 2^%d, alone %a 2^%d", name, c, corner, exponent, a->corner, a->corner_exponent);
  }
  if (m->lists[RELATIVE_MINIMA])
    CHECK(same(double_in(m, RELATIVE_MINIMA, c), a->relative_minimum), "%s: cell %zu: relative minimum %a, alone %a",
          name, c, double_in(m, RELATIVE_MINIMA, c), a->relative_minimum);
  if (m->lists[VOLUMES])
    CHECK(same(double_in(m, VOLUMES, c), a->volume), "%s: cell %zu: volume %a, alone %a", name, c,
          double_in(m, VOLUMES, c), a->volume);
  if (m->lists[VOLUME_EXPONENTS])
    CHECK(exponent_in(m, VOLUME_EXPONENTS, c) == a->volume_exponent, "%s: cell %zu: exponent of the volume", name, c);
}

static void check_counts(const char *name, unsigned lists, const hl_batch *batch, const answer *answers, size_t count) {
  size_t counts[3] = {0}, exact = 0, first = count;
  for (size_t c = count; c-- > 0;) {
    ++counts[answers[c].verdict];
    if (answers[c].status != HL_OK) first = c;
    else exact += asks_for_minima(lists) ? answers[c].minimum.is_exact : answers[c].is_decided_exactly;
  }
  CHECK(batch->unanswered == counts[HL_UNANSWERED] && batch->valid == counts[HL_VALID] &&
            batch->invalid == counts[HL_INVALID] && batch->first_unanswered == first,
        "%s, lists %x: %zu valid, %zu invalid, %zu unanswered from %zu on", name, lists, batch->valid, batch->invalid,
        batch->unanswered, batch->first_unanswered);
  /* An element that is invalid at sight is not tried in doubles, unless the list wants to know. */
  if (asks_for_minima(lists) || has(lists, IS_EXACT))
    CHECK(batch->exact == exact, "%s, lists %x: %zu exact, alone %zu", name, lists, batch->exact, exact);
  else CHECK(batch->exact <= exact, "%s, lists %x: %zu exact, alone %zu", name, lists, batch->exact, exact);
}

/* The lists with these bits, of these cells, by these kernels. */
static void check_batch(const lane_kernels *kernels, unsigned lists, const hl_cells *cells, const answer *answers,
                        size_t count) {
  const char *name = name_of(kernels);
  hl_batch batch;
  memory m = new_memory(lists, count, &batch);
  CHECK(classify_with(kernels, cells, &batch, NULL, NULL) == HL_OK, "%s, lists %x", name, lists);
  for (size_t c = 0; c < count; ++c) check_cell(name, lists, &m, c, &answers[c]);
  check_counts(name, lists, &batch, answers, count);
  check_ends_and_free(&m, name);
}

/* The cells that all tests take theirs from, and the answers one by one. */
static double *hexahedra;
static answer *answers_alone;

static void every_cell_is_answered_alone(void) {
  random_stream stream = {20260601};
  hexahedra = malloc((size_t)MANY * 24 * sizeof(double));
  answers_alone = malloc(MANY * sizeof *answers_alone);
  int verdicts[3] = {0}, classes[5] = {0}, exact = 0;
  for (int n = 0; n < MANY; ++n) {
    hard_hexahedron(&stream, n, hexahedra + 24 * n);
    answers_alone[n] = alone(hexahedra + 24 * n);
    CHECK(answers_alone[n].status == HL_OK, "status %d of %d", answers_alone[n].status, n);
    ++verdicts[answers_alone[n].verdict];
    ++classes[answers_alone[n].element_class];
    exact += answers_alone[n].minimum.is_exact;
  }
  CHECK(verdicts[HL_VALID] > MANY / 6 && verdicts[HL_INVALID] > MANY / 6 && exact > MANY / 12,
        "%d valid, %d invalid, %d exact", verdicts[HL_VALID], verdicts[HL_INVALID], exact);
  for (int i = HL_CLASS_VALID; i <= HL_CLASS_COLLAPSED; ++i)
    CHECK(classes[i] > MANY / 300, "%d of class %d", classes[i], i);
}

static void every_list_is_as_alone(void) {
  const lane_kernels *kernels[5];
  const int kernel_count = all_kernels(kernels);
  const hl_cells cells = {.coordinates = hexahedra, .coordinate_count = (size_t)MANY * 24};
  for (int k = 0; k < kernel_count; ++k) {
    check_batch(kernels[k], ALL_LISTS, &cells, answers_alone, MANY);
    check_batch(kernels[k], 1 << VERDICTS, &cells, answers_alone, MANY);
  }
}

static void the_lanes_decide_some_and_leave_some(void) {
  const lane_kernels *kernels[5];
  const int kernel_count = all_kernels(kernels);
  const hl_cells cells = {.coordinates = hexahedra, .coordinate_count = (size_t)MANY * 24};
  for (int k = 0; k < kernel_count; ++k) {
    if (!kernels[k]) continue;
    hl_batch batch;
    batch_stages stages;
    memory m = new_memory(ALL_LISTS, MANY, &batch);
    classify_with(kernels[k], &cells, &batch, NULL, &stages);
    CHECK(stages.after_lanes > 0 && stages.after_lanes < MANY * 9 / 10, "%s: %zu", name_of(kernels[k]),
          stages.after_lanes);
    check_ends_and_free(&m, name_of(kernels[k]));
  }
}

/* Hints are what they say. */
static void hints_are_true(void) {
  static uint8_t coincident[MANY], accepted_by[MANY];
  static float about[MANY];
  const batch_hints hints = {.coincident = coincident, .accepted_by = accepted_by, .relative_minima = about};
  const lane_kernels *kernels[5];
  const int kernel_count = all_kernels(kernels);
  const hl_cells cells = {.coordinates = hexahedra, .coordinate_count = (size_t)MANY * 24};
  for (int k = 0; k < kernel_count; ++k) {
    const char *name = name_of(kernels[k]);
    int coincident_count = 0, accepted = 0, known = 0;
    hl_batch batch;
    memory m = new_memory(ALL_LISTS, MANY, &batch);
    classify_with(kernels[k], &cells, &batch, &hints, NULL);
    for (int n = 0; n < MANY; ++n) {
      const answer *a = &answers_alone[n];
      uint8_t of_vertices[HL_VERTICES];
      bool is_coincident = false;
      find_coincidences(hexahedra + 24 * n, of_vertices);
      for (int v = 0; v < HL_VERTICES; ++v) is_coincident = is_coincident || of_vertices[v] != v;
      CHECK(coincident[n] == is_coincident, "%s: cell %d: coincident %d", name, n, coincident[n]);
      coincident_count += is_coincident;
      const unsigned expected = a->verdict == HL_VALID ? 0 : a->accepted_by & CORNER_CHECKS;
      CHECK(accepted_by[n] == expected, "%s: cell %d: accepted by %x, alone %x", name, n, accepted_by[n], expected);
      accepted += expected != 0;
      if (isnan(about[n])) continue;
      const double exact = isnan(a->relative_minimum) ? 0 : a->relative_minimum;
      CHECK(fabs((double)about[n] - exact) <= 0x1p-20 * fabs(exact), "%s: cell %d: about %g, exact %g", name, n,
            (double)about[n], exact);
      CHECK(!isnan(a->relative_minimum) || a->element_class == HL_CLASS_COLLAPSED, "%s: cell %d: no volume", name, n);
      ++known;
    }
    CHECK(coincident_count > TIMES(10) && accepted > TIMES(50), "%s: %d coincident, %d accepted", name,
          coincident_count, accepted);
    CHECK(kernels[k] ? known > TIMES(500) : known == 0, "%s: %d known", name, known);
    check_ends_and_free(&m, name);
  }
}

/* Cells from `first` on, in memory of their own so that a sanitizer sees what is read behind them, every tenth one unanswered. */
static double *copied_with_gaps(size_t first, size_t count) {
  double *own = malloc((24 * count + 1) * sizeof(double));
  memcpy(own, hexahedra + 24 * first, 24 * count * sizeof(double));
  for (size_t c = 3; c < count; c += 10) own[24 * c + c % 24] = NAN;
  return own;
}

/* Left out are valid cells alone: the others have the same bits in blocks of few and of many, of all alike and of none. */
static void relative_minima_of_valid_cells_are_left_out(void) {
  const lane_kernels *kernels[5];
  const int kernel_count = all_kernels(kernels);
  for (int k = 0; k < kernel_count; ++k) {
    const char *name = name_of(kernels[k]);
    int left_out = 0, known = 0;
    for (size_t length = 1; length <= MANY; length = length < LONGEST ? length + 1 : length + MANY - LONGEST) {
      const size_t first = length == MANY ? 0 : MANY / 36 * length;
      double *own = copied_with_gaps(first, length);
      float *all = malloc(length * sizeof *all), *some = malloc(length * sizeof *some);
      const hl_cells cells = {.coordinates = own, .coordinate_count = 24 * length};
      for (int leaves = 0; leaves < 2; ++leaves) {
        const batch_hints hints = {.relative_minima = leaves ? some : all, .leaves_valid = leaves};
        hl_batch batch;
        memory m = new_memory(ALL_LISTS, length, &batch);
        CHECK(classify_with(kernels[k], &cells, &batch, &hints, NULL) == HL_OK, "%s, %zu cells", name, length);
        check_ends_and_free(&m, name);
      }
      for (size_t c = 0; c < length; ++c) {
        const bool is_answered = c % 10 != 3, is_valid = answers_alone[first + c].verdict == HL_VALID;
        if (is_answered && !is_valid) {
          CHECK(!memcmp(all + c, some + c, sizeof *all), "%s, %zu cells: cell %zu: %a, among all %a", name, length, c,
                (double)some[c], (double)all[c]);
          known += !isnan(some[c]);
        } else {
          CHECK(isnan(some[c]) && (is_answered || isnan(all[c])), "%s, %zu cells: cell %zu: %a", name, length, c,
                (double)some[c]);
          left_out += !isnan(all[c]);
        }
      }
      free(some);
      free(all);
      free(own);
    }
    CHECK(kernels[k] ? left_out > TIMES(200) && known > TIMES(200) : left_out + known == 0, "%s: %d left out, %d known",
          name, left_out, known);
  }
}

/* The box is that of a plain loop, from nothing on and from a box that is there, whatever else is asked for. */
static void boxes_are_those_of_the_cells(void) {
  static const double starts[2][6] = {{INFINITY, INFINITY, INFINITY, -INFINITY, -INFINITY, -INFINITY},
                                      {-0x1p-250, 0.5, -3, 0x1p-250, 1.5, -2}};
  const unsigned lists[3] = {1 << VERDICTS, 1 << VERDICTS | 1 << CLASSES | 1 << STATUSES, ALL_LISTS};
  const lane_kernels *kernels[5];
  const int kernel_count = all_kernels(kernels);
  for (int k = 0; k < kernel_count; ++k)
    for (size_t length = 0; length <= MANY; length = length < LONGEST ? length + 1 : length + MANY - LONGEST) {
      const size_t first = length == MANY ? 0 : MANY / 36 * length;
      double *own = malloc((24 * length + 1) * sizeof(double)), box[6], expected[6];
      memcpy(own, hexahedra + 24 * first, 24 * length * sizeof(double));
      memcpy(box, starts[length % 2], sizeof box);
      memcpy(expected, box, sizeof box);
      for (size_t i = 0; i < 24 * length; ++i) {
        if (own[i] < expected[i % 3]) expected[i % 3] = own[i];
        if (own[i] > expected[3 + i % 3]) expected[3 + i % 3] = own[i];
      }
      const hl_cells cells = {.coordinates = own, .coordinate_count = 24 * length};
      const batch_hints hints = {.box = box};
      hl_batch batch;
      memory m = new_memory(lists[length % 3], length, &batch);
      CHECK(classify_with(kernels[k], &cells, &batch, &hints, NULL) == HL_OK, "%zu cells", length);
      for (int i = 0; i < 6; ++i)
        CHECK(box[i] == expected[i], "%s, %zu cells: %d of the box is %a, not %a", name_of(kernels[k]), length, i,
              box[i], expected[i]);
      check_ends_and_free(&m, name_of(kernels[k]));
      free(own);
    }
}

/* Each list with nothing but what it needs, then subsets at random; those that lack one are refused and nothing is written. */
static void every_subset_of_lists_is_as_alone(void) {
  enum { CELLS = SHARE == 1 ? 300 : 100, SUBSETS = 60 };
  const lane_kernels *kernels[5];
  const int kernel_count = all_kernels(kernels);
  random_stream stream = {20260604};
  int refused = 0;
  for (int n = 0; n < LISTS + SUBSETS; ++n) {
    unsigned lists = n < LISTS ? 1u << n | 1 << VERDICTS : (unsigned)random_bits(&stream) & ALL_LISTS;
    if (n < LISTS && (n == MINIMA || n == CORNER_MINIMA)) lists |= 1 << EXPONENTS;
    if (n < LISTS && n == VOLUMES) lists |= 1 << VOLUME_EXPONENTS;
    if (n >= LISTS && n % 4) lists |= 1 << VERDICTS;
    const size_t first = random_bits(&stream) % (MANY - CELLS);
    const hl_cells cells = {.coordinates = hexahedra + 24 * first, .coordinate_count = CELLS * 24};
    const lane_kernels *kernel = kernels[n % kernel_count];
    if (is_complete(lists)) {
      check_batch(kernel, lists, &cells, answers_alone + first, CELLS);
      continue;
    }
    ++refused;
    hl_batch batch;
    memory m = new_memory(lists, CELLS, &batch);
    batch.valid = batch.invalid = batch.unanswered = batch.exact = 7;
    CHECK(classify_with(kernel, &cells, &batch, NULL, NULL) == HL_MISSING_LIST, "lists %x", lists);
    CHECK(batch.valid + batch.invalid + batch.unanswered + batch.exact == 0, "lists %x: counts", lists);
    for (int i = 0; i < LISTS; ++i)
      CHECK(!m.lists[i] || is_untouched(&m, i, 0), "lists %x: %s were written", lists, list_table[i].name);
    check_ends_and_free(&m, name_of(kernel));
  }
  CHECK(refused > 5 && refused < SUBSETS - 20, "%d subsets were refused", refused);
}

/* Batches of 0 to 33 cells from any cell on: lanes that are not used hold other cells or rubbish. */
static void every_length_is_as_alone(void) {
  const lane_kernels *kernels[5];
  const int kernel_count = all_kernels(kernels);
  for (int k = 0; k < kernel_count; ++k)
    for (size_t length = 0; length <= LONGEST; ++length)
      for (int indexed = 0; indexed < 2; ++indexed) {
        const size_t first = MANY / 36 * length;
        double *own = malloc((length * 24 + 1) * sizeof(double)); /* so that a sanitizer sees what is read behind it */
        uint32_t *indices = malloc((length * 8 + 1) * sizeof(uint32_t));
        for (size_t i = 0; i < length * 24; ++i) own[i] = hexahedra[24 * first + i];
        for (size_t i = 0; i < length * 8; ++i) indices[i] = (uint32_t)i;
        const hl_cells cells = {own, length * 24, indexed ? indices : NULL, indexed ? length * 8 : 0};
        check_batch(kernels[k], ALL_LISTS, &cells, answers_alone + first, length);
        check_batch(kernels[k], 1 << VERDICTS | 1 << IS_EXACT, &cells, answers_alone + first, length);
        free(indices);
        free(own);
      }
}

/* Cells with a NaN, an infinity or a bad index among good ones: many in a block, all of it, or one; by coordinates and by indices. */
static void bad_cells_do_not_stop_the_others(void) {
  enum { CELLS = 290 };
  static double v[CELLS * 24];
  static uint32_t indices[CELLS * 8];
  static answer answers[CELLS];
  const double bad_values[3] = {NAN, INFINITY, -INFINITY};
  const double shares[4] = {0.004, 0.1, 0.5, 1};
  const unsigned lists[3] = {ALL_LISTS, 1 << VERDICTS | 1 << STATUSES,
                             1 << VERDICTS | 1 << STATUSES | 1 << IS_EXACT | 1 << CLASSES};
  const lane_kernels *kernels[5];
  const int kernel_count = all_kernels(kernels);
  random_stream stream = {20260603};
  for (int trial = 0; trial < 8; ++trial) { /* each share with and without indices */
    const bool indexed = trial % 2;
    const size_t first = random_bits(&stream) % (MANY - CELLS);
    for (int c = 0; c < CELLS; ++c) {
      double *own = v + 24 * (indexed ? CELLS - 1 - c : c);
      memcpy(own, hexahedra + 24 * (first + (size_t)c), 24 * sizeof *own);
      for (int i = 0; i < 8; ++i) indices[8 * c + i] = (uint32_t)(8 * (CELLS - 1 - c) + i);
      answers[c] = answers_alone[first + (size_t)c];
      if (random_unit(&stream) >= shares[trial / 2 % 4]) continue;
      answers[c] = (answer){.status = HL_NOT_FINITE};
      if (indexed && random_bits(&stream) % 2) {
        answers[c].status = HL_NO_SUCH_POINT;
        indices[8 * c + (int)(random_bits(&stream) % 8)] = random_bits(&stream) % 2 ? 0xffffffffu : CELLS * 8;
      } else {
        own[random_bits(&stream) % 24] = bad_values[random_bits(&stream) % 3];
      }
      /* An index out of range is what is said of a cell that has both. */
      if (indexed && random_bits(&stream) % 4 == 0) own[0] = NAN;
    }
    const hl_cells cells = {v, CELLS * 24, indexed ? indices : NULL, indexed ? CELLS * 8 : 0};
    /* Lists in turn, each with every kernel. */
    for (int k = 0; k < kernel_count; ++k) check_batch(kernels[k], lists[(trial / 2 + k) % 3], &cells, answers, CELLS);
  }
}

/* Infinities at one place are no coincidence, and no cell is invalid at sight by them. */
static void coincident_infinities_are_not_finite(void) {
  double v[24];
  uint8_t verdict = 9, status = 9;
  memcpy(v, unit_cube, sizeof v);
  for (int i = 0; i < 6; ++i) v[i] = INFINITY;
  const hl_cells cells = {.coordinates = v, .coordinate_count = 24};
  hl_batch batch = {.verdicts = &verdict, .statuses = &status};
  CHECK(hl_classify(&cells, &batch) == HL_OK && verdict == HL_UNANSWERED && status == HL_NOT_FINITE, "%d %d", verdict,
        status);
}

static void incomplete_lists_are_refused(void) {
  double v[48] = {0};
  uint32_t indices[16] = {0};
  uint8_t verdicts[3] = {9, 9, 9};
  hl_batch batch = {.verdicts = verdicts};
  const struct {
    size_t coordinates, indices, cell;
  } wrong[] = {{23, 0, 0}, {25, 0, 1}, {47, 0, 1}, {48, 15, 1}, {48, 1, 0}, {47, 8, 1}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
    hl_cells cells = {v, wrong[i].coordinates, wrong[i].indices ? indices : NULL, wrong[i].indices};
    CHECK(hl_classify(&cells, &batch) == HL_INCOMPLETE, "list %zu", i);
    CHECK(batch.first_unanswered == wrong[i].cell, "list %zu: cell %zu", i, batch.first_unanswered);
    CHECK(verdicts[0] == 9, "list %zu was written", i);
  }
  hl_cells none = {NULL, 0, indices, 0};
  CHECK(hl_classify(&none, &batch) == HL_OK && batch.valid + batch.invalid + batch.unanswered == 0 &&
            batch.first_unanswered == 0,
        "no cells");
}

int main(void) {
  printf("  vectors: %s\n", hl_vectors());
  RUN(every_cell_is_answered_alone);
  RUN(every_list_is_as_alone);
  RUN(the_lanes_decide_some_and_leave_some);
  RUN(hints_are_true);
  RUN(relative_minima_of_valid_cells_are_left_out);
  RUN(boxes_are_those_of_the_cells);
  RUN(every_subset_of_lists_is_as_alone);
  RUN(every_length_is_as_alone);
  RUN(bad_cells_do_not_stop_the_others);
  RUN(coincident_infinities_are_not_finite);
  RUN(incomplete_lists_are_refused);
  free(answers_alone);
  free(hexahedra);
  return test_summary();
}
