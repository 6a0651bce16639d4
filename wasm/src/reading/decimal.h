/*
 * Numbers in text, as programs print them: a scan of one, and the double that is nearest to it, ties to even.
 */
#ifndef HL_READING_DECIMAL_H
#define HL_READING_DECIMAL_H

#include <stdbool.h>
#include <stdint.h>

/* A number of a text: sign * leading * 10^exponent, and more digits behind `leading` if has_more. */
typedef struct hl_decimal {
  const uint8_t *first; /* the first digit or the point */
  const uint8_t *last;  /* behind the last digit, before the exponent */
  uint64_t leading;     /* the first 19 significant digits */
  int32_t exponent;     /* of ten, of `leading` */
  int32_t stated;       /* the exponent that is written, 0 if none is */
  int32_t digits;       /* significant ones: from the first that is not 0 */
  bool is_negative;
  bool is_whole; /* without a point and an exponent */
  bool has_more; /* a digit other than 0 behind `leading` */
} hl_decimal;

/*
 * Scans the number that begins at `at`: a sign, digits and a point among them, an exponent after e, E, d or D, or, if
 * has_bare_exponents, after its sign alone. Returns where it ends, at most `end`; NULL if there is none.
 */
const uint8_t *hl_scan_decimal(const uint8_t *at, const uint8_t *end, bool has_bare_exponents, hl_decimal *number);

/* The nearest double; an infinity for what is too large. hl_start_decimals must have been called. */
double hl_double_of(const hl_decimal *number);

/* True if the number has fewer than 17 digits and is a double: printing it has lost nothing. */
bool hl_is_exact(const hl_decimal *number);

/* Computes the powers of five. */
void hl_start_decimals(void);

#endif
