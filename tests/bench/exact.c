/* The work that npm run bench -- exact times, natively and in wasm: one question asked of some elements over and over, and how many
   multiplications of integers it took. */
#include "../../wasm/src/bernstein.h"
#include "../../wasm/src/exact.h"
#include "../../wasm/src/filter.h"
#include "../../wasm/src/scaling.h"
#include "hexlens.h"

/* Questions about the elements one by one, or about all of them as a batch. */
typedef enum question_kind { VERDICT, MINIMUM, REPORT, VERDICTS, MINIMA, QUESTIONS } question_kind;

enum { MOST = 1024 };

static double elements[HL_COORDINATES * MOST];
static uint8_t verdicts[MOST];
static double minima[MOST], minimizers[3 * MOST], corner_minima[MOST];
static int16_t exponents[MOST];
static hl_report report;

static void ask_one(question_kind question, const double *vertices) {
  hl_verdict verdict;
  hl_minimum minimum;
  if (question == VERDICT) hl_decide(vertices, &verdict);
  else if (question == MINIMUM) hl_boundary_minimum(vertices, HL_ROOTS_B, &minimum);
  else hl_analyze(vertices, &report);
}

static void ask(question_kind question, int count, int repeats) {
  const hl_cells cells = {elements, (size_t)count * HL_COORDINATES, NULL, 0};
  hl_batch batch = {.verdicts = verdicts};
  if (question == MINIMA) {
    batch.minima = minima;
    batch.minimizers = minimizers;
    batch.corner_minima = corner_minima;
    batch.exponents = exponents;
  }
  for (int n = 0; n < repeats; ++n) {
    if (question >= VERDICTS) hl_classify(&cells, &batch);
    else
      for (int c = 0; c < count; ++c) ask_one(question, elements + HL_COORDINATES * c);
  }
}

/* The work of integers for an answer; none where doubles give it, or where it is zero at sight. */
static exact_cost cost_of(question_kind question, const double *vertices) {
  exact_cost cost = {0, 0};
  hl_verdict verdict;
  if (question == VERDICT || question == VERDICTS) {
    edge_vectors edges;
    double bernstein[HL_BERNSTEIN];
    scaled_edge_vectors(vertices, &edges);
    jacdet_bernstein(&edges, bernstein);
    if (!is_zero_at_sight(vertices) && !is_settled_by_filter(bernstein, &verdict)) exact_verdict(vertices, bernstein, &cost);
    return cost;
  }
  hl_minimum minimum;
  exact_minimum exact;
  exact_values values;
  hl_boundary_minimum(vertices, HL_ROOTS_B, &minimum);
  if (!minimum.is_exact) return cost;
  if (question == REPORT) find_exact_values(vertices, &values, &cost);
  else find_exact_minimum(vertices, &exact, &cost);
  return cost;
}

static exact_cost mean_cost(question_kind question, int count) {
  exact_cost sum = {0, 0};
  for (int c = 0; c < count; ++c) {
    const exact_cost cost = cost_of(question, elements + HL_COORDINATES * c);
    sum.multiplications += cost.multiplications;
    sum.products += cost.products;
  }
  return (exact_cost){sum.multiplications / (uint32_t)count, sum.products / (uint64_t)count};
}

#if defined __wasm__

#define EXPORT(name) __attribute__((export_name(#name)))

EXPORT(elements_address) double *elements_address(void) { return elements; }
EXPORT(ask) void ask_in_wasm(int kind, int count, int repeats) { ask((question_kind)kind, count, repeats); }

#else

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* In nanoseconds of this process alone: others on the machine do not count. */
static double cpu_time(void) { return 1e9 / CLOCKS_PER_SEC * (double)clock(); }

static double timed(question_kind question, int count, int repeats) {
  const double begin = cpu_time();
  ask(question, count, repeats);
  return (cpu_time() - begin) / ((double)count * repeats);
}

typedef struct set {
  question_kind question;
  int count, repeats;
  double *elements, *times;
} set;

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static void load(const set *s) {
  for (int i = 0; i < HL_COORDINATES * s->count; ++i) elements[i] = s->elements[i];
}

/* Long enough for the clock. */
static const double SAMPLE = 1e6;

static set read_set(const double head[2], int rounds) {
  set s = {.question = (question_kind)head[0], .count = (int)head[1], .repeats = 1};
  if (s.count < 1 || s.count > MOST || s.question >= QUESTIONS) exit(2);
  s.elements = malloc(sizeof elements / MOST * (size_t)s.count);
  s.times = malloc(sizeof(double) * (size_t)rounds);
  if (fread(s.elements, sizeof elements / MOST, (size_t)s.count, stdin) != (size_t)s.count) exit(2);
  load(&s);
  while (timed(s.question, s.count, s.repeats) * s.count * s.repeats < SAMPLE) s.repeats *= 2;
  return s;
}

/* exact ROUNDS: reads sets from standard input, as doubles: question, count, elements. Writes a line each: the median time of an
   element in nanoseconds, multiplications, and products of limbs. */
int main(int argc, char **argv) {
  enum { MOST_SETS = 4096 };
  static set sets[MOST_SETS];
  const int rounds = argc == 2 ? atoi(argv[1]) : 0;
  if (rounds < 1) return 2;
  int count = 0;
  double head[2];
  while (fread(head, sizeof head, 1, stdin) == 1 && count < MOST_SETS) sets[count++] = read_set(head, rounds);
  for (int round = 0; round < rounds; ++round)
    for (int i = 0; i < count; ++i) {
      load(&sets[i]);
      sets[i].times[round] = timed(sets[i].question, sets[i].count, sets[i].repeats);
    }
  for (int i = 0; i < count; ++i) {
    const set *s = &sets[i];
    load(s);
    qsort(s->times, (size_t)rounds, sizeof(double), ascending);
    const exact_cost cost = mean_cost(s->question, s->count);
    printf("%.3f %u %llu\n", s->times[rounds / 2], cost.multiplications, (unsigned long long)cost.products);
  }
  return 0;
}

#endif
