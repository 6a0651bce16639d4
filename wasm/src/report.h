/* Declarations that reports and batches share. */
#ifndef HL_REPORT_H
#define HL_REPORT_H

#include "checks.h"
#include "exact.h"
#include "hexlens.h"
#include "scaling.h"

/* True if doubles are certain of the verdict and know the minimum as well; `permanent` is the
   greatest one, `minimum` the least candidate. The verdict is written in any case. */
bool is_settled_by_doubles(const double bernstein[HL_BERNSTEIN], double permanent, double minimum, hl_verdict *verdict);

/* hl_analyze by integers, also where doubles would do. */
hl_status analyze_exactly(const double vertices[HL_COORDINATES], hl_report *report);

/* Finds faces, candidates, the least and the greatest of them from report->bernstein. */
void find_candidates(const double vertices[HL_COORDINATES], hl_report *report);

/* Error bounds of the coefficients on the boundary and of all, and the exponent of them all. */
typedef struct precision {
  double boundary_error, error;
  int exponent;
} precision;

/* Completes the parts that need the verdict and the precision of the coefficients. */
void complete_report(const double vertices[HL_COORDINATES], const edge_vectors *edges, precision given,
                     const middle_point *middle, hl_report *report);

enum {
  MAX_JACDETS = 7 + HL_CHECKS + HL_BERNSTEIN + HL_MAX_CANDIDATES + HL_FACES * (HL_FACE_BERNSTEIN + 2 + HL_MAX_ROOTS)
};

/* Lists every jacdet of the report; returns how many there are. */
int list_jacdets(hl_report *report, double *list[MAX_JACDETS]);

/* All but what finish_report does, from exact values; the jacdets are times 2^ the exponent returned, the quartics times 2^(3 unit). */
int exact_report(const double vertices[HL_COORDINATES], const edge_vectors *edges, const exact_values *x,
                 hl_report *report);

/* Applies the rules to a face, from its coefficients and the least candidate before it. */
void judge_face(double running_minimum, hl_face_report *face);

/* The class by the verdict and, of an invalid element, by jacdet being negative or 0 everywhere. */
hl_class class_of(const double vertices[HL_COORDINATES], hl_verdict verdict);

/* Bit 1 << c for each check c whose number in the report is positive. */
unsigned checks_that_accept(const double vertices[HL_COORDINATES]);

/* The same of these two alone, which is sooner known. */
enum { CORNER_CHECKS = 1 << HL_CHECK_CORNERS | 1 << HL_CHECK_CORNERS_AND_CENTRE };
unsigned corner_checks_that_accept(const double vertices[HL_COORDINATES]);

/* Finds the least vertex at each vertex's position; returns the shape that they make. */
hl_shape find_coincidences(const double vertices[HL_COORDINATES], uint8_t coincident[HL_VERTICES]);

/* The integral of jacdet, rounded to the nearest double. */
scaled_double find_volume(const double vertices[HL_COORDINATES]);

/* Columns of the determinants whose sum is twelve times the volume: see integral.c. */
extern const unsigned char volume_columns[3][3][2][2];

/* minimum * 2^exponent over |volume| * 2^volume_exponent: NaN for a volume of 0; what the doubles have no room for is the double of its sign
   that is greatest, or the least normal one. */
double relative_minimum(double minimum, int exponent, double volume, int volume_exponent);

#endif
