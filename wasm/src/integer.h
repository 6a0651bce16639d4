/* Integers of any length, for what doubles leave open: sign and magnitude in limbs of 32 bits. Their memory is a workspace that
   the caller owns and gives back by marks; nothing else is allocated. */
#ifndef HL_INTEGER_H
#define HL_INTEGER_H

#include "scaling.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Limbs that are handed out one after the other. When there are no more, `is_full` is set, results are 0, and whoever owns the
   workspace begins again with a larger one. */
typedef struct workspace {
  uint32_t *limbs;
  size_t capacity, used;
  bool is_full;
  uint64_t products; /* of limb and limb, for benchmarks */
  uint32_t multiplications;
} workspace;

/* The index of the limbs in the workspace, the least first and the greatest not 0, and their
   count, negative for a negative integer: in one word, which is passed as such. The limbs do not
   change. */
typedef struct integer {
  uint64_t place; /* offset << 32 | length */
} integer;

static const integer zero = {0};

static inline int32_t integer_length(integer a) { return (int32_t)(uint32_t)a.place; }
static inline bool is_zero(integer a) { return integer_length(a) == 0; }
static inline bool is_negative(integer a) { return integer_length(a) < 0; }
static inline bool is_positive(integer a) { return integer_length(a) > 0; }
static inline int integer_sign(integer a) { return is_positive(a) - is_negative(a); }
static inline integer integer_negated(integer a) {
  return (integer){(a.place & 0xffffffff00000000u) | (uint32_t)-integer_length(a)};
}
static inline integer integer_magnitude(integer a) { return is_negative(a) ? integer_negated(a) : a; }

integer integer_of(workspace *w, int64_t value);

/* x = integer * 2^exponent for a finite x; the integer is odd, or 0 with exponent 0. */
integer integer_of_double(workspace *w, double x, int *exponent);

/* Bits of the magnitude; 0 for 0. */
int integer_bits(const workspace *w, integer a);

/* -1, 0 or 1 for a < b, a = b, a > b. */
int integer_compare(const workspace *w, integer a, integer b);

integer integer_sum(workspace *w, integer a, integer b);
integer integer_difference(workspace *w, integer a, integer b);
integer integer_product(workspace *w, integer a, integer b);

integer integer_times(workspace *w, integer a, int32_t factor);

/* a * 2^shift; for a negative shift the magnitude loses its last bits. */
integer integer_shifted(workspace *w, integer a, int shift);

/* The number of times that 2 divides a, which is not 0. */
int integer_trailing_zeros(const workspace *w, integer a);

/* Gives back what was handed out since `mark` = w->used but for these, which are moved. */
void integer_keep(workspace *w, size_t mark, integer *kept, int count);

/* a * 2^exponent, rounded to the nearest double, of ties to the even one. */
scaled_double rounded_integer(const workspace *w, integer a, int exponent);

/* The sign of a b - c d: by their leading digits where these tell it, else by the products. */
int integer_compare_products(workspace *w, integer a, integer b, integer c, integer d);

/* numerator / denominator * 2^exponent, rounded to the nearest double, of ties to the even one; denominator > 0. */
scaled_double rounded_quotient(workspace *w, integer numerator, integer denominator, int exponent);

/* A floor of |numerator / denominator| to 62 bits: it is in [bits, bits + 1) * 2^exponent, for a quotient that is not 0. */
typedef struct quotient_floor {
  int64_t bits;
  int exponent;
  bool is_exact;
} quotient_floor;
quotient_floor floor_of_quotient(workspace *w, integer numerator, integer denominator);

#endif
