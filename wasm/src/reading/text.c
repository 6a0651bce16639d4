/* Runs and rows of numbers, straight from the bytes of a text. */
#include "text.h"

#include <stddef.h>

enum { MOST_WHOLE_DIGITS = 15, MOST_PLACE = 1 << 24, LONGEST_WORD = 1000 };

static inline bool is_blank(uint8_t byte) { return byte == ' ' || byte == '\n' || byte == '\r' || byte == '\t'; }

/* True at a byte that may follow a number in a run. */
static inline bool ends_word(const uint8_t *at, const uint8_t *end) { return at == end || *at <= ' '; }

static void note_digits(hl_taken *taken, const hl_decimal *number) {
  const uint32_t digits = (uint32_t)number->digits;
  if (digits > taken->most_digits) taken->most_digits = digits;
  if (digits > taken->most_rounded && !hl_is_exact(number)) taken->most_rounded = digits;
}

hl_taken hl_numbers(const uint8_t *from, const uint8_t *limit, const uint8_t *end, double *list, uint32_t most) {
  hl_taken taken = {0};
  const uint8_t *last = from;
  while (taken.count < most) {
    const uint8_t *at = last;
    while (at < end && is_blank(*at)) ++at;
    if (at >= limit) break;
    const uint8_t *first = at;
    hl_decimal number;
    at = hl_scan_decimal(at, end, false, &number);
    /* A word so long may be cut at `end`. */
    if (at == NULL || !ends_word(at, end) || at - first > LONGEST_WORD) break;
    list[taken.count++] = hl_double_of(&number);
    if (!number.is_whole) note_digits(&taken, &number);
    last = at;
  }
  taken.bytes = (uint32_t)(last - from);
  return taken;
}

hl_taken hl_indices(const uint8_t *from, const uint8_t *limit, const uint8_t *end, uint32_t *list, uint32_t most,
                    uint32_t largest) {
  hl_taken taken = {0};
  const uint8_t *last = from;
  while (taken.count < most) {
    const uint8_t *at = last;
    while (at < end && is_blank(*at)) ++at;
    if (at >= limit) break;
    const uint8_t *first = at;
    uint64_t value = 0;
    for (; at < end && (uint8_t)(*at - '0') < 10 && value <= largest; ++at) value = 10 * value + (uint64_t)(*at - '0');
    if (at == first || value > largest || !ends_word(at, end) || at - first > LONGEST_WORD) break;
    list[taken.count++] = (uint32_t)value;
    last = at;
  }
  taken.bytes = (uint32_t)(last - from);
  return taken;
}

static inline bool is_space(uint8_t byte) { return byte == ' ' || byte == '\t' || byte == '\r'; }

static const uint8_t *pass_spaces(const uint8_t *at, const uint8_t *end) {
  while (at < end && is_space(*at)) ++at;
  return at;
}

/* The end of a field of so many columns, which a line may cut. */
static const uint8_t *field_end(const uint8_t *at, const uint8_t *end, uint32_t width) {
  const uint8_t *last = (uint32_t)(end - at) < width ? end : at + width;
  for (const uint8_t *byte = at; byte < last; ++byte)
    if (*byte == '\n') return byte;
  return last;
}

/* The end of the number of a field, whose rest is blank; NULL if it is none. A tab stands for
   columns that are not here. */
static const uint8_t *number_in(const uint8_t *at, const uint8_t *end, uint8_t kind, uint32_t width, hl_decimal *number,
                                const uint8_t **first, const uint8_t **last) {
  const uint8_t *to = width == 0 ? end : field_end(at, end, width);
  while (at < to && (*at == ' ' || (width == 0 && *at == '\t'))) ++at;
  *first = at;
  if (kind == HL_WHOLE && !(at < to && (uint8_t)(*at - '0') < 10)) return NULL;
  at = hl_scan_decimal(at, to, kind == HL_REAL && width > 0, number);
  if (at == NULL) return NULL;
  *last = at;
  if (kind == HL_WHOLE && (!number->is_whole || number->digits > MOST_WHOLE_DIGITS)) return NULL;
  if (width == 0) return at < end && (*at <= ' ' || *at == ',') ? at : NULL;
  while (at < to && (*at == ' ' || *at == '\r')) ++at;
  return at == to ? at : NULL;
}

hl_taken hl_rows(const uint8_t *from, const uint8_t *end, const uint8_t *pattern, uint32_t pattern_length,
                 double *numbers, uint32_t *places, uint32_t most_rows) {
  hl_taken taken = {0};
  const uint8_t *row = from;
  while (taken.count < most_rows && row < end && row - from < MOST_PLACE) {
    const uint8_t *at = row;
    double *number = numbers;
    uint32_t *place = places;
    hl_taken digits = taken;
    for (uint32_t i = 0; i < pattern_length && at != NULL;) {
      const uint8_t kind = pattern[i++];
      if (kind == HL_LINE_END || kind == HL_COMMA) {
        at = pass_spaces(at, end);
        at = at < end && *at == (kind == HL_COMMA ? ',' : '\n') ? at + 1 : NULL;
        continue;
      }
      const uint32_t width = pattern[i++];
      if (kind == HL_BYTES) {
        for (uint32_t k = 0; k < width && at != NULL; ++k) at = at < end && *at == pattern[i + k] ? at + 1 : NULL;
        i += width;
      } else if (kind == HL_BLANKS) {
        for (uint32_t k = 0; k < width && at != NULL; ++k) at = at < end && *at == ' ' ? at + 1 : NULL;
      } else {
        hl_decimal decimal;
        const uint8_t *first, *last;
        at = number_in(at, end, kind, width, &decimal, &first, &last);
        if (at == NULL) break;
        if (kind == HL_WHOLE) *number++ = (double)decimal.leading;
        else {
          *number++ = hl_double_of(&decimal);
          note_digits(&digits, &decimal);
          if (last - first > UINT8_MAX) at = NULL;
          if (place != NULL) *place++ = (uint32_t)(last - first) << 24 | (uint32_t)(first - from);
        }
      }
    }
    if (at == NULL) break;
    taken = digits;
    ++taken.count;
    row = at;
    numbers = number;
    places = place;
  }
  taken.bytes = (uint32_t)(row - from);
  return taken;
}
