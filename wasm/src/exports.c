/* The exports of WebAssembly: no pointers but those of one static input and one output. */
#include "hexlens.h"

#define EXPORT(name) __attribute__((export_name(#name)))

/* The vertices, then a reference point. */
static double input[HL_COORDINATES + 3];
static double output[HL_PACKED_REPORT];

EXPORT(input_address) double *input_address(void) { return input; }

EXPORT(input_length) int input_length(void) { return (int)(sizeof input / sizeof *input); }

EXPORT(output_address) double *output_address(void) { return output; }

EXPORT(output_length) int output_length(void) { return HL_PACKED_REPORT; }

/* Each returns an hl_status; the answer is in the output, packed. */
EXPORT(analyze) int analyze(void) {
  static hl_report report;
  hl_status status = hl_analyze(input, &report);
  if (status == HL_OK) hl_pack_report(&report, output);
  return (int)status;
}

EXPORT(boundary_minimum) int boundary_minimum(int variant) {
  hl_minimum minimum;
  hl_status status = hl_boundary_minimum(input, variant == HL_ROOTS ? HL_ROOTS : HL_ROOTS_B, &minimum);
  if (status == HL_OK) hl_pack_minimum(&minimum, output);
  return (int)status;
}

EXPORT(decide) int decide(void) {
  hl_verdict verdict = HL_UNANSWERED;
  hl_status status = hl_decide(input, &verdict);
  output[0] = verdict;
  return (int)status;
}

EXPORT(jacobian_at) int jacobian_at(void) {
  hl_jacobian jacobian;
  hl_status status = hl_jacobian_at(input, input + HL_COORDINATES, &jacobian);
  if (status == HL_OK) hl_pack_jacobian(&jacobian, output);
  return (int)status;
}
