/* Integers of 64 bits, of which a mesh needs the low halves. */
#ifndef HL_READING_HALVES_H
#define HL_READING_HALVES_H

#include <stdint.h>

/* The bounds of a list of integers, and its step. */
typedef struct hl_halves {
  uint32_t high;           /* 0 if no high half is anything else */
  int32_t least, greatest; /* of the low halves, as integers with a sign */
  uint32_t step; /* from each low half to the next, if it is the same everywhere and there are two or more; else 0 */
} hl_halves;

/* `count` > 0 integers, the low half of each first, into `low`. */
hl_halves hl_low_halves(const uint32_t *words, uint32_t count, uint32_t *low);

#endif
