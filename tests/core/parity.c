/* Reads hexahedra as raw doubles, 24 each, from standard input and writes for each its status and its packed report,
   minimum, verdict and Jacobian as raw doubles: what tests/unit/parity.test.ts compares with the wasm's memory. */
#include "hexlens.h"

#include <stdio.h>

static void write_doubles(const double *values, size_t count) { fwrite(values, sizeof(double), count, stdout); }

int main(void) {
  static double packed[HL_PACKED_REPORT];
  static hl_report report;
  double vertices[HL_COORDINATES];
  const double point[3] = {0.25, 0.625, 0.8125};
  while (fread(vertices, sizeof vertices, 1, stdin) == 1) {
    double status = hl_analyze(vertices, &report);
    write_doubles(&status, 1);
    if (status != HL_OK) continue;
    write_doubles(packed, hl_pack_report(&report, packed));
    for (int variant = HL_ROOTS; variant <= HL_ROOTS_B; ++variant) {
      hl_minimum minimum;
      hl_boundary_minimum(vertices, (hl_variant)variant, &minimum);
      write_doubles(packed, hl_pack_minimum(&minimum, packed));
    }
    hl_verdict verdict = HL_UNANSWERED;
    hl_decide(vertices, &verdict);
    double number = verdict;
    write_doubles(&number, 1);
    hl_jacobian jacobian;
    hl_jacobian_at(vertices, point, &jacobian);
    write_doubles(packed, hl_pack_jacobian(&jacobian, packed));
  }
  return 0;
}
