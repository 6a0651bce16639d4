/* Numbers of a text, many at once: runs between blanks, and rows of a pattern. */
#ifndef HL_READING_TEXT_H
#define HL_READING_TEXT_H

#include <stdint.h>

#include "decimal.h"

/* Numbers and bytes read from a text. */
typedef struct hl_taken {
  uint32_t count; /* numbers of a run, rows of a table */
  uint32_t bytes; /* from the beginning to behind the last of them */
  /* Significant digits of real numbers, in runs those with a point or an exponent: the most, and the most of one that is no double. */
  uint32_t most_digits, most_rounded;
} hl_taken;

/*
 * Numbers between blanks from `from` on, into `list`, at most `most`. They end before the first word that is none or has more than 1000 bytes, or
 * that begins at `limit` or later; `end` is where the text ends or is cut.
 */
hl_taken hl_numbers(const uint8_t *from, const uint8_t *limit, const uint8_t *end, double *list, uint32_t most);

/* The same of whole numbers up to `largest`, in digits alone. */
hl_taken hl_indices(const uint8_t *from, const uint8_t *limit, const uint8_t *end, uint32_t *list, uint32_t most,
                    uint32_t largest);

/* Items of a row, one after the other; each but COMMA, BLANKS and LINE_END with its width: 0 for a
   word between blanks or commas, else columns. */
enum {
  HL_LINE_END, /* blanks, and the end of the line */
  HL_COMMA,    /* blanks around a comma */
  HL_BLANKS,   /* so many columns */
  HL_WHOLE,    /* a number in digits alone, below 10^15 */
  HL_REAL,     /* a number, whose exponent may be without its letter in columns */
  HL_BYTES     /* so many bytes that follow in the pattern */
};

/*
 * Rows of a pattern from `from` on: of each its numbers into `numbers`, and of each HL_REAL, where `places` is not NULL, its first byte from
 * `from` on and in the upper 8 bits how many it has. They end before the first row that does not fit or is not whole before `end`.
 */
hl_taken hl_rows(const uint8_t *from, const uint8_t *end, const uint8_t *pattern, uint32_t pattern_length,
                 double *numbers, uint32_t *places, uint32_t most_rows);

#endif
