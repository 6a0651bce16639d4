/* The paper's sweep: 100,000 elements a sigma, the same draws for all; the counts of invalid ones against its table of
   strict-validity runtimes, within four standard deviations of a binomial count. */
#include "check.h"
#include "hexlens.h"
#include "random.h"

enum { HEXAHEDRA = 100000, ROWS = 20 };

/* Invalid elements of 100,000 at sigma 0.1, 0.2, ... 2.0, from the percentages of the paper's Table 1. */
static const int paper_invalid[ROWS] = {1,     6675,  44225, 75045, 88707, 94546, 97116, 98249, 98860, 99208,
                                        99419, 99549, 99637, 99693, 99744, 99788, 99811, 99829, 99854, 99865};

static void counts_of_invalid_elements_are_the_papers(void) {
  random_stream stream = {20260404};
  long invalid[ROWS] = {0}, open = 0;
  for (long n = 0; n < HEXAHEDRA; ++n) {
    double displacement[24], vertices[24];
    for (int i = 0; i < 24; ++i) displacement[i] = random_normal(&stream);
    for (int row = 0; row < ROWS; ++row) {
      for (int i = 0; i < 24; ++i) vertices[i] = unit_cube[i] + 0.1 * (row + 1) * displacement[i];
      hl_verdict verdict = HL_UNANSWERED;
      hl_minimum minimum;
      CHECK(hl_decide(vertices, &verdict) == HL_OK && verdict != HL_UNANSWERED, "status");
      if (verdict == HL_INVALID) ++invalid[row];
      if (n < 1000 && hl_boundary_minimum(vertices, HL_ROOTS_B, &minimum) == HL_OK) open += minimum.is_exact;
    }
  }
  printf("    left open by doubles: %ld of %d\n", open, 1000 * ROWS);
  CHECK(open <= 20, "%ld left open", open);
  for (int row = 0; row < ROWS; ++row) {
    double share = (double)paper_invalid[row] / HEXAHEDRA;
    double deviation = sqrt(HEXAHEDRA * share * (1 - share));
    double off = ((double)invalid[row] - paper_invalid[row]) / deviation;
    printf("    sigma %.1f: %ld invalid, paper %d, %+.1f standard deviations\n", 0.1 * (row + 1), invalid[row],
           paper_invalid[row], off);
    CHECK(fabs(off) <= 4, "sigma %.1f", 0.1 * (row + 1));
  }
}

int main(void) {
  RUN(counts_of_invalid_elements_are_the_papers);
  return test_summary();
}
