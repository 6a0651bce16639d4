/* The paper's experiment for Roots, Roots+B and Hexlens: one row of its tables at a time, natively (main) and in WebAssembly
   (the exports). The displacements come from outside, so that both have the same elements. */
#include "../../wasm/src/batch.h"
#include "roots.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { MOST = 100000, COORDINATES = 24 };

enum { VALIDITY = 0, MINIMUM = 1 };
enum { ROOTS = 0, ROOTS_B = 1, HEXLENS = 2, METHODS = 3, DETERMINANTS = 3, LANES = 4, LOADS = 5 };

static double displacements[MOST * COORDINATES], hexahedra[MOST * COORDINATES];
static int element_count;

/* The answers of Hexlens and of Roots+B. */
static uint8_t verdicts[MOST];
static double minima[MOST], minimizers[3 * MOST], corner_minima[MOST], roots_minima[MOST];
static int16_t exponents[MOST];
static bool roots_valid[MOST];
static hl_batch batch;
static batch_stages stages;
static volatile double sink;

static const double unit_cube[COORDINATES] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};

static void set_row(double sigma) {
  for (int n = 0; n < element_count; ++n)
    for (int i = 0; i < COORDINATES; ++i)
      hexahedra[COORDINATES * n + i] = unit_cube[i] + sigma * displacements[COORDINATES * n + i];
}

static void run_roots(int query, bool with_bounds) {
  double minimizer[3];
  for (int n = 0; n < element_count; ++n) {
    const double *vertices = hexahedra + COORDINATES * n;
    if (query == VALIDITY) roots_valid[n] = roots_validity(vertices, with_bounds);
    else roots_minima[n] = roots_minimum(vertices, with_bounds, minimizer);
  }
}

static void run_hexlens(int query) {
  hl_cells cells = {hexahedra, (size_t)element_count * COORDINATES, NULL, 0};
  batch = (hl_batch){.verdicts = verdicts};
  if (query == MINIMUM) {
    batch.minima = minima;
    batch.minimizers = minimizers;
    batch.corner_minima = corner_minima;
    batch.exponents = exponents;
  }
  classify_with(best_lanes(), &cells, &batch, NULL, &stages);
}

/* The fast stage alone, and the reading of the elements alone. */
static void run_lanes(int query) {
  const lane_kernels *kernels = best_lanes();
  static lane_minima out;
  uint8_t block[HL_BLOCK];
  if (!kernels) return;
  for (int n = 0; n + HL_BLOCK <= element_count; n += HL_BLOCK)
    if (query == VALIDITY) kernels->decide(hexahedra + COORDINATES * n, HL_BLOCK, block);
    else kernels->corners(hexahedra + COORDINATES * n, HL_BLOCK, &out);
}

static void run_loads(void) {
  double sums[4] = {0};
  for (int i = 0; i + 4 <= COORDINATES * element_count; i += 4)
    for (int k = 0; k < 4; ++k) sums[k] += hexahedra[i + k];
  sink = sums[0] + sums[1] + sums[2] + sums[3];
}

static void run_determinants(void) {
  double sum = 0;
  for (int n = 0; n < element_count; ++n) sum += twenty_determinants(hexahedra + COORDINATES * n);
  sink = sum;
}

static void run(int query, int method) {
  switch (method) {
  case ROOTS: run_roots(query, false); break;
  case ROOTS_B: run_roots(query, true); break;
  case HEXLENS: run_hexlens(query); break;
  case DETERMINANTS: run_determinants(); break;
  case LANES: run_lanes(query); break;
  default: run_loads();
  }
}

/* A checksum of the last run of Hexlens: a number for all of its bits, by which native and wasm are compared (FNV-1a by words). */
static uint32_t fingerprint(int query) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (int n = 0; n < element_count; ++n) {
    uint64_t words[5] = {verdicts[n], 0, 0, 0, 0};
    if (query == MINIMUM) {
      memcpy(words + 1, minima + n, sizeof(double));
      memcpy(words + 2, minimizers + 3 * n, 3 * sizeof(double));
    }
    for (int w = 0; w < 5; ++w) hash = (hash ^ words[w]) * 0x100000001b3u;
  }
  return (uint32_t)(hash ^ hash >> 32);
}

/* A minimum of Roots+B is not certified: far from it is what two sound programs cannot be. */
static int far_minima(void) {
  int count = 0;
  for (int n = 0; n < element_count; ++n)
    if (!(fabs(minima[n] - roots_minima[n]) <= 1e-9 * fmax(1, fabs(minima[n])))) ++count;
  return count;
}

#ifdef __wasm__

#define EXPORT(name) __attribute__((export_name(#name)))

EXPORT(displacements_address) double *displacements_address(void) { return displacements; }
EXPORT(verdicts_address) uint8_t *verdicts_address(void) { return verdicts; }
EXPORT(roots_valid_address) bool *roots_valid_address(void) { return roots_valid; }
EXPORT(most) int most(void) { return MOST; }
EXPORT(set_sigma) void set_sigma(int count, double sigma) {
  element_count = count;
  set_row(sigma);
}
EXPORT(run_method) void run_method(int query, int method) { run(query, method); }
EXPORT(after_lanes) int after_lanes(void) { return (int)stages.after_lanes; }
EXPORT(undecided) int undecided(void) { return (int)stages.after_doubles; }
EXPORT(fingerprint_of) uint32_t fingerprint_of(int query) { return fingerprint(query); }
EXPORT(far_minima_count) int far_minima_count(void) { return far_minima(); }

#else

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* In nanoseconds of this process alone: others on the machine do not count. */
static double cpu_time(void) { return 1e9 / CLOCKS_PER_SEC * (double)clock(); }

static double timed(int query, int method) {
  double begin = cpu_time();
  run(query, method);
  return (cpu_time() - begin) / element_count;
}

static int ascending(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* sweep COUNT TRIALS SIGMA...: reads the displacements from standard input, writes one line of numbers a row and query: query,
   sigma, the methods' median times, stages, fingerprint, far minima; then the verdicts of both, one character an element. */
int main(int argc, char **argv) {
  enum { MOST_TRIALS = 99, ALL = 6 };
  if (argc < 4) return 2;
  element_count = atoi(argv[1]);
  const int trials = atoi(argv[2]);
  if (element_count < 1 || element_count > MOST || trials < 1 || trials > MOST_TRIALS) return 2;
  if (fread(displacements, sizeof(double) * COORDINATES, (size_t)element_count, stdin) != (size_t)element_count) return 2;
  fprintf(stderr, "%s\n", hl_vectors());
  for (int row = 3; row < argc; ++row) {
    set_row(atof(argv[row]));
    for (int query = VALIDITY; query <= MINIMUM; ++query) {
      static double times[ALL][MOST_TRIALS];
      for (int trial = 0; trial < trials; ++trial)
        for (int m = 0; m < ALL; ++m) {
          int method = (m + trial) % ALL;
          times[method][trial] = timed(query, method);
        }
      printf("%d %s", query, argv[row]);
      for (int m = 0; m < ALL; ++m) {
        qsort(times[m], (size_t)trials, sizeof(double), ascending);
        printf(" %.3f", times[m][trials / 2]);
      }
      run(query, HEXLENS);
      run(query, ROOTS_B);
      printf(" %zu %zu %u %d\n", stages.after_lanes, stages.after_doubles, fingerprint(query),
             query == MINIMUM ? far_minima() : 0);
    }
  }
  return 0;
}

#endif
