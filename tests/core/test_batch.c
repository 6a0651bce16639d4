/* A batch is its cells one by one, bit for bit, by every fast stage that this machine runs and without any. */
#include "../../wasm/src/batch.h"
#include "check.h"
#include "hexlens.h"
#include "random.h"

#include <stdlib.h>
#include <string.h>

enum { MANY = 6000, LONGEST = 33 };

/* All there is to compare of one cell. */
typedef struct answer {
  uint8_t verdict, element_class;
  uint16_t accepted_by;
  double minimum, minimizer[3], corner;
  int16_t exponent;
} answer;

/* Lists for a batch, with room behind that must stay as it is. */
typedef struct lists {
  uint8_t *verdicts;
  double *minima, *minimizers, *corner_minima;
  int16_t *exponents;
} lists;

static lists new_lists(size_t count) {
  lists l = {malloc(count + 1), malloc((count + 1) * sizeof(double)), malloc((3 * count + 1) * sizeof(double)),
             malloc((count + 1) * sizeof(double)), malloc((count + 1) * sizeof(int16_t))};
  memset(l.verdicts, 0x55, count + 1);
  memset(l.minima, 0x55, (count + 1) * sizeof(double));
  memset(l.minimizers, 0x55, (3 * count + 1) * sizeof(double));
  memset(l.corner_minima, 0x55, (count + 1) * sizeof(double));
  memset(l.exponents, 0x55, (count + 1) * sizeof(int16_t));
  return l;
}

static void free_lists(lists l) {
  free(l.verdicts);
  free(l.minima);
  free(l.minimizers);
  free(l.corner_minima);
  free(l.exponents);
}

static hl_batch batch_into(const lists *l, bool minima) {
  hl_batch batch = {.verdicts = l->verdicts};
  if (!minima) return batch;
  batch.minima = l->minima;
  batch.minimizers = l->minimizers;
  batch.corner_minima = l->corner_minima;
  batch.exponents = l->exponents;
  return batch;
}

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
  hl_minimum minimum;
  hl_verdict verdict;
  answer a;
  CHECK(hl_decide(v, &verdict) == HL_OK && hl_analyze(v, &report) == HL_OK, "status");
  hl_boundary_minimum(v, HL_ROOTS_B, &minimum);
  CHECK(verdict == report.verdict, "decide says %d, analyze %d", verdict, report.verdict);
  a.verdict = (uint8_t)verdict;
  a.is_exact = report.is_exact;
  a.element_class = (uint8_t)report.element_class;
  a.accepted_by = 0;
  for (int c = 0; c < HL_CHECKS; ++c) a.accepted_by |= (uint16_t)((report.checks[c] > 0) << c);
  a.relative_minimum = report.relative_minimum;
  a.volume = report.volume;
  a.volume_exponent = (int16_t)report.volume_exponent;
  a.minimum = minimum.minimizer.value;
  a.exponent = (int16_t)minimum.exponent;
  memcpy(a.minimizer, minimum.minimizer.point, sizeof a.minimizer);
  CHECK(memcmp(report.minimizer.point, a.minimizer, sizeof a.minimizer) == 0, "two minimizers");
  /* The report has more numbers to bring to one exponent than the batch. */
  a.corner = ldexp(report.corner_minimum, report.exponent - a.exponent);
  return a;
}

static bool same(double x, double y) { return memcmp(&x, &y, sizeof x) == 0; }

static void check_cell(const char *name, size_t c, const lists *l, const answer *a) {
  CHECK(l->verdicts[c] == a->analyzed, "%s: cell %zu: verdict %d, alone %d", name, c, l->verdicts[c], a->analyzed);
  /* With the least corner a second number decides about the exponent. */
  int off = l->exponents[c] - a->exponent;
  double minimum = off == 0 ? l->minima[c] : ldexp(l->minima[c], off);
  CHECK(same(minimum, a->minimum), "%s: cell %zu: minimum %a, alone %a", name, c, minimum, a->minimum);
  double corner = off == 0 ? l->corner_minima[c] : ldexp(l->corner_minima[c], off);
  CHECK(same(corner, a->corner) || (a->corner == 0 && a->exponent != 0), "%s: cell %zu: corner %a, alone %a", name, c,
        corner, a->corner);
  CHECK(memcmp(l->minimizers + 3 * c, a->minimizer, sizeof a->minimizer) == 0, "%s: cell %zu: minimizer", name, c);
}

static double *many_hexahedra(uint64_t seed) {
  random_stream stream = {seed};
  double *v = malloc((size_t)MANY * 24 * sizeof(double));
  for (int n = 0; n < MANY; ++n) hard_hexahedron(&stream, n, v + 24 * n);
  return v;
}

static void every_cell_is_as_alone(void) {
  double *v = many_hexahedra(20260601);
  answer *answers = malloc(MANY * sizeof *answers);
  for (int n = 0; n < MANY; ++n) answers[n] = alone(v + 24 * n);
  const lane_kernels *kernels[5];
  int kernel_count = all_kernels(kernels);
  hl_cells cells = {.coordinates = v, .coordinate_count = (size_t)MANY * 24};
  for (int k = 0; k < kernel_count; ++k) {
    const char *name = name_of(kernels[k]);
    lists l = new_lists(MANY);
    hl_batch batch = batch_into(&l, true);
    batch_stages stages;
    CHECK(classify_with(kernels[k], &cells, &batch, &stages) == HL_OK, "%s", name);
    for (size_t c = 0; c < MANY; ++c) check_cell(name, c, &l, &answers[c]);
    CHECK(!kernels[k] || (stages.after_lanes > 0 && stages.after_lanes < MANY * 9 / 10), "%s: %zu", name,
          stages.after_lanes);
    batch = batch_into(&l, false);
    CHECK(classify_with(kernels[k], &cells, &batch, &stages) == HL_OK, "%s", name);
    size_t counts[3] = {0};
    for (size_t c = 0; c < MANY; ++c) {
      CHECK(l.verdicts[c] == answers[c].decided, "%s: cell %zu: %d, alone %d", name, c, l.verdicts[c],
            answers[c].decided);
      ++counts[answers[c].decided];
    }
    CHECK(batch.undecided == counts[0] && batch.valid == counts[1] && batch.invalid == counts[2], "%s: counts", name);
    for (int i = 0; i < 3; ++i) CHECK(counts[i] > 100, "only %zu of verdict %d", counts[i], i);
    free_lists(l);
  }
  free(answers);
  free(v);
}

/* Batches of 0 to 33 cells from any cell on: lanes that are not used hold other cells or rubbish. */
static void every_length_is_as_alone(void) {
  double *v = many_hexahedra(20260602);
  const lane_kernels *kernels[5];
  int kernel_count = all_kernels(kernels);
  for (int k = 0; k < kernel_count; ++k)
    for (size_t length = 0; length <= LONGEST; ++length)
      for (int indexed = 0; indexed < 2; ++indexed) {
        size_t first = 37 * length;
        double *own = malloc((length * 24 + 1) * sizeof(double)); /* so that a sanitizer sees what is read behind it */
        uint32_t *indices = malloc((length * 8 + 1) * sizeof(uint32_t));
        for (size_t i = 0; i < length * 24; ++i) own[i] = v[24 * first + i];
        for (size_t i = 0; i < length * 8; ++i) indices[i] = (uint32_t)i;
        lists l = new_lists(length);
        hl_batch batch = batch_into(&l, true);
        hl_cells cells = {own, length * 24, indexed ? indices : NULL, indexed ? length * 8 : 0};
        CHECK(classify_with(kernels[k], &cells, &batch, NULL) == HL_OK, "%zu", length);
        for (size_t c = 0; c < length; ++c) {
          answer a = alone(v + 24 * (first + c));
          check_cell(name_of(kernels[k]), c, &l, &a);
        }
        CHECK(l.verdicts[length] == 0x55 && l.exponents[length] == 0x5555, "written behind %zu cells", length);
        const unsigned char *behind[3] = {(unsigned char *)(l.minima + length),
                                          (unsigned char *)(l.minimizers + 3 * length),
                                          (unsigned char *)(l.corner_minima + length)};
        for (int i = 0; i < 3; ++i) CHECK(behind[i][0] == 0x55 && behind[i][7] == 0x55, "written behind %zu", length);
        free_lists(l);
        free(indices);
        free(own);
      }
  free(v);
}

static void bad_cells_are_named(void) {
  enum { CELLS = 150 };
  const double bad_values[3] = {NAN, INFINITY, -INFINITY};
  const lane_kernels *kernels[5];
  int kernel_count = all_kernels(kernels);
  random_stream stream = {20260603};
  for (int trial = 0; trial < 300; ++trial) {
    static double v[CELLS * 24];
    static uint32_t indices[CELLS * 8];
    for (int c = 0; c < CELLS; ++c) random_hexahedron(&stream, trial % 3, v + 24 * c);
    for (uint32_t i = 0; i < CELLS * 8; ++i) indices[i] = CELLS * 8 - 1 - i;
    size_t bad = random_bits(&stream) % CELLS, at = 8 * bad + random_bits(&stream) % 8;
    bool is_index = trial % 2, minima = trial / 2 % 2, indexed = is_index || trial / 4 % 2;
    if (is_index) indices[at] = CELLS * 8 + (uint32_t)(trial % 5 == 0 ? 0xffffffffu - CELLS * 8 : (unsigned)trial / 2);
    else if (indexed) v[3 * indices[at] + (unsigned)trial % 3] = bad_values[trial / 8 % 3];
    else v[3 * at + (unsigned)trial % 3] = bad_values[trial / 8 % 3];
    hl_cells cells = {v, CELLS * 24, indexed ? indices : NULL, indexed ? CELLS * 8 : 0};
    for (int k = 0; k < kernel_count; ++k) {
      lists l = new_lists(CELLS);
      hl_batch batch = batch_into(&l, minima);
      hl_status status = classify_with(kernels[k], &cells, &batch, NULL);
      CHECK(status == (is_index ? HL_NO_SUCH_POINT : HL_NOT_FINITE) && batch.first_bad_cell == bad,
            "%s, trial %d: status %d, cell %zu instead of %zu", name_of(kernels[k]), trial, status,
            batch.first_bad_cell, bad);
      CHECK(batch.valid + batch.invalid + batch.undecided == bad, "counts of trial %d", trial);
      for (size_t c = 0; c < CELLS; ++c)
        CHECK((l.verdicts[c] == 0x55) == (c >= bad), "trial %d: cell %zu is %d", trial, c, l.verdicts[c]);
      free_lists(l);
    }
  }
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
    CHECK(batch.first_bad_cell == wrong[i].cell, "list %zu: cell %zu", i, batch.first_bad_cell);
    CHECK(verdicts[0] == 9, "list %zu was written", i);
  }
  hl_cells none = {NULL, 0, indices, 0};
  CHECK(hl_classify(&none, &batch) == HL_OK && batch.valid + batch.invalid + batch.undecided == 0, "no cells");
}

int main(void) {
  printf("  vectors: %s\n", hl_vectors());
  RUN(every_cell_is_as_alone);
  RUN(every_length_is_as_alone);
  RUN(bad_cells_are_named);
  RUN(incomplete_lists_are_refused);
  return test_summary();
}
