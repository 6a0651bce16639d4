/* The report as a list of doubles, in the order of the structs of hexlens.h. web/core/unpack.ts reads the same order. */
#include "hexlens.h"
#include "topology.h"

#include <math.h>

typedef struct cursor {
  double *next;
} cursor;

HL_INLINE void put(cursor *c, double value) { *c->next++ = value; }

static void put_all(cursor *c, const double *values, int count) {
  for (int i = 0; i < count; ++i) put(c, values[i]);
}

static void put_candidate(cursor *c, const hl_candidate *candidate) {
  put(c, candidate->kind);
  put(c, candidate->id);
  put_all(c, candidate->point, 3);
  put_all(c, candidate->position, 3);
  put(c, candidate->value);
}

static void put_face(cursor *c, const hl_face_report *face) {
  put_all(c, face->bernstein, HL_FACE_BERNSTEIN);
  put(c, face->lower_bound);
  put(c, face->running_minimum);
  put(c, face->skipped_by_minimum_rule);
  put(c, face->skipped_by_validity_rule);
  put_all(c, face->quartic, HL_QUARTIC);
  put(c, face->quartic_exponent);
  put(c, face->quartic_is_zero);
  put(c, face->root_count);
  for (int r = 0; r < face->root_count; ++r) {
    put(c, face->roots[r].t);
    put(c, face->roots[r].a);
    put(c, face->roots[r].s);
    put(c, face->roots[r].fate);
  }
}

size_t hl_pack_report(const hl_report *report, double packed[HL_PACKED_REPORT]) {
  cursor c = {packed};
  put(&c, report->verdict);
  put(&c, report->is_exact);
  put(&c, report->exponent);
  put_candidate(&c, &report->minimizer);
  put(&c, report->minimum_error);
  put(&c, report->volume_minimum.lower);
  put(&c, report->volume_minimum.upper);
  put_all(&c, report->volume_minimum.point, 3);
  put_all(&c, report->volume_minimum.position, 3);
  put_all(&c, report->checks, HL_CHECKS);
  put_candidate(&c, &report->maximizer);
  put(&c, report->corner_minimum);
  put(&c, report->edge_minimum);
  put(&c, report->scaled_jacobian);
  put_all(&c, report->bernstein, HL_BERNSTEIN);
  for (int f = 0; f < HL_FACES; ++f) put_face(&c, &report->faces[f]);
  put(&c, report->candidate_count);
  for (int i = 0; i < report->candidate_count; ++i) put_candidate(&c, &report->candidates[i]);
  put(&c, report->element_class);
  put(&c, report->shape);
  for (int v = 0; v < HL_VERTICES; ++v) put(&c, report->coincident[v]);
  put(&c, report->volume);
  put(&c, report->volume_exponent);
  put(&c, report->volume == 0 ? 0 : report->relative_minimum); /* what the reader sees is none */
  return (size_t)(c.next - packed);
}

size_t hl_pack_minimum(const hl_minimum *minimum, double packed[HL_PACKED_MINIMUM]) {
  cursor c = {packed};
  put_candidate(&c, &minimum->minimizer);
  put(&c, minimum->exponent);
  put(&c, minimum->is_exact);
  return (size_t)(c.next - packed);
}

size_t hl_pack_jacobian(const hl_jacobian *jacobian, double packed[HL_PACKED_JACOBIAN]) {
  cursor c = {packed};
  put_all(&c, jacobian->position, 3);
  for (int column = 0; column < 3; ++column) put_all(&c, jacobian->columns[column], 3);
  for (int r = 0; r < 3; ++r) put(&c, jacobian->axis_exponent[r]);
  put(&c, jacobian->jacdet);
  put(&c, jacobian->exponent);
  return (size_t)(c.next - packed);
}

size_t hl_pack_place(const hl_place *place, double packed[HL_PACKED_PLACE]) {
  cursor c = {packed};
  put_all(&c, place->position, 3);
  put(&c, place->is_moved);
  put(&c, place->is_closed);
  put(&c, place->measure);
  put(&c, place->value);
  put(&c, place->bound);
  put(&c, place->relative_minimum == place->relative_minimum ? place->relative_minimum : NAN);
  put(&c, place->present_relative_minimum == place->present_relative_minimum ? place->present_relative_minimum : NAN);
  put(&c, place->unit_exponent);
  put(&c, place->round_count);
  put(&c, place->hold_count);
  for (int i = 0; i < place->hold_count; ++i) {
    put(&c, place->holds[i].cell);
    put_all(&c, place->holds[i].point, 3);
    put(&c, place->holds[i].weight);
    put(&c, place->holds[i].scale);
    put(&c, place->holds[i].is_by_sign);
  }
  return (size_t)(c.next - packed);
}

size_t hl_pack_untangled(const hl_untangled *result, double packed[HL_PACKED_UNTANGLED]) {
  cursor c = {packed};
  put(&c, (double)result->invalid_before);
  put(&c, (double)result->invalid_after);
  put(&c, (double)result->below_before);
  put(&c, (double)result->below_after);
  put(&c, (double)result->moved_count);
  put(&c, (double)result->place_count);
  put(&c, (double)result->sweep_count);
  put(&c, (double)result->too_many_count);
  put(&c, result->greatest_distance);
  put(&c, result->mean_distance);
  put(&c, result->least_before == result->least_before ? result->least_before : NAN);
  put(&c, result->least_after == result->least_after ? result->least_after : NAN);
  put(&c, result->is_stopped);
  return (size_t)(c.next - packed);
}
