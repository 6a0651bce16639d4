/* Integers against __int128 where they are short, against identities where they are long, and roundings against an exact comparison
   with the neighbouring doubles. A workspace that is full says so and never makes anything else of it. */
#include "../../wasm/src/integer.h"
#include "check.h"
#include "random.h"

#include <stdlib.h>
#include <string.h>

__extension__ typedef __int128 wide;
__extension__ typedef unsigned __int128 unsigned_wide;

enum { CAPACITY = 200000 };
static uint32_t limbs[CAPACITY];
static random_stream stream = {20261001};

static workspace whole_workspace(void) { return (workspace){.limbs = limbs, .capacity = CAPACITY}; }

/* An integer of up to so many bits, of either sign, often with few or runs of them set. */
static integer random_integer(workspace *w, int most_bits) {
  integer x = zero;
  for (int bits = (int)(random_bits(&stream) % (unsigned)(most_bits + 1)); bits > 0; bits -= 31) {
    const int part = bits < 31 ? bits : 31;
    const uint64_t mask = ((uint64_t)1 << part) - 1, choice = random_bits(&stream) % 4;
    const uint64_t digits = choice == 0 ? 0 : choice == 1 ? mask : random_bits(&stream) & mask;
    x = integer_sum(w, integer_shifted(w, x, part), integer_of(w, (int64_t)digits));
  }
  return random_bits(&stream) % 2 ? integer_negated(x) : x;
}

static bool equal(const workspace *w, integer a, integer b) { return integer_compare(w, a, b) == 0; }

static integer integer_of_wide(workspace *w, wide value) {
  const bool is_below = value < 0;
  unsigned_wide magnitude = is_below ? -(unsigned_wide)value : (unsigned_wide)value;
  integer x = zero;
  for (int i = 3; i >= 0; --i)
    x = integer_sum(w, integer_shifted(w, x, 32), integer_of(w, (int64_t)(uint32_t)(magnitude >> 32 * i)));
  return is_below ? integer_negated(x) : x;
}

static int64_t random_word(void) {
  const uint64_t bits = random_bits(&stream) >> random_bits(&stream) % 64;
  return random_bits(&stream) % 2 ? (int64_t)(bits >> 1) : -(int64_t)(bits >> 1);
}

static int sign_of(wide x) { return (x > 0) - (x < 0); }

static int bits_of(unsigned_wide x) {
  int bits = 0;
  for (; x; x >>= 1) ++bits;
  return bits;
}

static void short_integers_are_those_of_the_machine(void) {
  for (long n = 0; n < TIMES(100000); ++n) {
    workspace w = whole_workspace();
    const wide x = random_word(), y = random_word();
    const integer a = integer_of(&w, (int64_t)x), b = integer_of(&w, (int64_t)y);
    const int32_t factor = (int32_t)random_word();
    CHECK(equal(&w, integer_sum(&w, a, b), integer_of_wide(&w, x + y)), "%ld: sum", n);
    CHECK(equal(&w, integer_difference(&w, a, b), integer_of_wide(&w, x - y)), "%ld: difference", n);
    CHECK(equal(&w, integer_product(&w, a, b), integer_of_wide(&w, x * y)), "%ld: product", n);
    CHECK(equal(&w, integer_times(&w, a, factor), integer_of_wide(&w, x * factor)), "%ld: times %d", n, factor);
    CHECK(integer_sign(a) == sign_of(x) && integer_compare(&w, a, b) == sign_of(x - y), "%ld: order", n);
    CHECK(integer_bits(&w, a) == bits_of((unsigned_wide)(x < 0 ? -x : x)), "%ld: bits", n);
    CHECK(x == 0 || integer_trailing_zeros(&w, a) == __builtin_ctzll((unsigned long long)x), "%ld: zeros", n);
    const int shift = (int)(random_bits(&stream) % 60);
    CHECK(equal(&w, integer_shifted(&w, a, shift), integer_of_wide(&w, x * ((wide)1 << shift))), "%ld: shift", n);
    const wide cut = (x < 0 ? -x : x) >> shift;
    CHECK(equal(&w, integer_shifted(&w, a, -shift), integer_of_wide(&w, x < 0 ? -cut : cut)), "%ld: shift down", n);
  }
}

static void long_integers_obey_their_laws(void) {
  for (long n = 0; n < TIMES(20000); ++n) {
    workspace w = whole_workspace();
    const integer a = random_integer(&w, 2000), b = random_integer(&w, n % 2 ? 2000 : 60), c = random_integer(&w, 700);
    const integer sum = integer_sum(&w, a, b), difference = integer_difference(&w, a, b);
    const integer squares = integer_difference(&w, integer_product(&w, a, a), integer_product(&w, b, b));
    CHECK(equal(&w, integer_product(&w, sum, difference), squares), "%ld: (a + b)(a - b)", n);
    CHECK(equal(&w, integer_product(&w, sum, c), integer_sum(&w, integer_product(&w, c, a), integer_product(&w, b, c))),
          "%ld: (a + b)c", n);
    CHECK(equal(&w, integer_difference(&w, sum, b), a) && equal(&w, integer_sum(&w, difference, b), a), "%ld: back", n);
    CHECK(integer_compare(&w, a, b) == integer_sign(difference), "%ld: order", n);
    CHECK(integer_compare_products(&w, a, b, c, sum) ==
              integer_compare(&w, integer_product(&w, a, b), integer_product(&w, c, sum)),
          "%ld: order of products", n);
    const int shift = (int)(random_bits(&stream) % 300);
    const integer power = integer_shifted(&w, integer_of(&w, 1), shift), shifted = integer_shifted(&w, a, shift);
    CHECK(equal(&w, shifted, integer_product(&w, a, power)), "%ld: shift by %d", n, shift);
    CHECK(equal(&w, integer_shifted(&w, shifted, -shift), a), "%ld: and back", n);
    CHECK(integer_bits(&w, shifted) == (is_zero(a) ? 0 : integer_bits(&w, a) + shift), "%ld: bits", n);
    CHECK(is_zero(a) || integer_trailing_zeros(&w, shifted) == integer_trailing_zeros(&w, a) + shift, "%ld: zeros", n);
    const integer cut = integer_shifted(&w, a, -shift),
                  rest = integer_difference(&w, a, integer_shifted(&w, cut, shift));
    CHECK(integer_bits(&w, rest) <= shift && integer_sign(rest) * integer_sign(a) >= 0, "%ld: cut", n);
    CHECK(!w.is_full, "%ld: full", n);
  }
}

/* Products that agree in all but their last bits. */
static void products_are_told_apart_in_the_last_bit(void) {
  for (long n = 0; n < TIMES(5000); ++n) {
    workspace w = whole_workspace();
    const integer a = random_integer(&w, 500), one = integer_of(&w, 1), square = integer_product(&w, a, a);
    const integer below = integer_difference(&w, a, one), above = integer_sum(&w, a, one);
    CHECK(integer_compare_products(&w, a, a, below, above) == 1, "%ld: a^2 is above a^2 - 1", n);
    CHECK(integer_compare_products(&w, below, above, a, a) == -1, "%ld: the other way round", n);
    CHECK(integer_compare_products(&w, square, one, a, a) == 0, "%ld: equal", n);
    CHECK(integer_compare_products(&w, integer_negated(square), one, a, a) == (is_zero(a) ? 0 : -1), "%ld: sign", n);
  }
}

static void doubles_are_integers_times_powers_of_two(void) {
  for (long n = 0; n < TIMES(100000); ++n) {
    workspace w = whole_workspace();
    uint64_t bits = random_bits(&stream);
    if ((bits >> 52 & 0x7ff) == 0x7ff) bits ^= (uint64_t)1 << 62;
    if (n % 8 == 0) bits &= 0x800fffffffffffffu; /* subnormal */
    if (n % 1000 == 0) bits &= (uint64_t)1 << 63;
    double x;
    memcpy(&x, &bits, sizeof x);
    int exponent;
    const integer a = integer_of_double(&w, x, &exponent);
    const scaled_double back = rounded_integer(&w, a, exponent);
    CHECK(ldexp(back.mantissa, back.exponent) == x, "%ld: %a", n, x);
    CHECK(is_zero(a) ? exponent == 0 : integer_trailing_zeros(&w, a) == 0, "%ld: %a is not odd", n, x);
  }
}

/* The integer m with mantissa = m / 2^53, and the neighbours in the binade. */
static integer mantissa_bits(workspace *w, scaled_double x) { return integer_of(w, (int64_t)ldexp(x.mantissa, 53)); }

/* numerator / denominator is at most half a unit from x, and at half of one x is even: exactly, by
   2 |numerator 2^53 - m 2^e denominator| <= 2^e denominator. The binade's lower end has a nearer neighbour below. */
static void check_nearest(workspace *w, integer numerator, integer denominator, scaled_double x, long n) {
  const double size = fabs(x.mantissa);
  CHECK(size >= 0.5 && size < 1 && (x.mantissa < 0) == is_negative(numerator), "%ld: mantissa %a", n, x.mantissa);
  const int shift = 53 - x.exponent;
  const integer left = integer_shifted(w, numerator, shift > 0 ? shift : 0),
                unit = integer_shifted(w, denominator, shift < 0 ? -shift : 0), m = mantissa_bits(w, x),
                off = integer_difference(w, left, integer_product(w, m, unit));
  const int far = integer_compare(w, integer_shifted(w, integer_magnitude(off), 1), unit);
  CHECK(far <= 0, "%ld: more than half a unit off", n);
  CHECK(far < 0 || (int64_t)ldexp(x.mantissa, 53) % 2 == 0, "%ld: a tie is not even", n);
  if (size == 0.5 && integer_sign(off) * integer_sign(numerator) < 0)
    CHECK(integer_compare(w, integer_shifted(w, integer_magnitude(off), 2), unit) <= 0, "%ld: at a power of two", n);
}

static void integers_are_rounded_to_the_nearest_double(void) {
  for (long n = 0; n < TIMES(50000); ++n) {
    workspace w = whole_workspace();
    integer a = random_integer(&w, n % 3 ? 400 : 70);
    if (n % 5 == 0) { /* a tie, or next to one */
      a = integer_of(&w, (int64_t)(random_bits(&stream) >> 10 | (uint64_t)1 << 53 | 1));
      a = integer_sum(&w, integer_shifted(&w, a, 80), integer_of(&w, (int64_t)(random_bits(&stream) % 3) - 1));
    }
    const int exponent = (int)(random_bits(&stream) % 12000) - 6000;
    scaled_double x = rounded_integer(&w, a, exponent);
    if (is_zero(a)) {
      CHECK(x.mantissa == 0 && x.exponent == 0, "%ld: zero", n);
      continue;
    }
    x.exponent -= exponent;
    check_nearest(&w, a, integer_of(&w, 1), x, n);
  }
}

static void quotients_are_rounded_to_the_nearest_double(void) {
  for (long n = 0; n < TIMES(30000); ++n) {
    workspace w = whole_workspace();
    integer denominator = integer_magnitude(random_integer(&w, n % 2 ? 300 : 40)), numerator = random_integer(&w, 500);
    if (is_zero(denominator)) denominator = integer_of(&w, 3);
    if (n % 4 == 0) /* exactly a double, or a tie */
      numerator = integer_product(&w, denominator, integer_of(&w, random_word() >> 10));
    const int exponent = (int)(random_bits(&stream) % 12000) - 6000;
    scaled_double x = rounded_quotient(&w, numerator, denominator, exponent);
    if (is_zero(numerator)) {
      CHECK(x.mantissa == 0 && x.exponent == 0, "%ld: zero", n);
      continue;
    }
    x.exponent -= exponent;
    check_nearest(&w, numerator, denominator, x, n);
    const quotient_floor q = floor_of_quotient(&w, numerator, denominator);
    const integer size = integer_magnitude(numerator),
                  shifted = q.exponent < 0 ? integer_shifted(&w, size, -q.exponent) : size,
                  unit = q.exponent > 0 ? integer_shifted(&w, denominator, q.exponent) : denominator,
                  rest = integer_difference(&w, shifted, integer_product(&w, integer_of(&w, q.bits), unit));
    CHECK(q.bits >> 61 == 1, "%ld: not 62 bits", n);
    CHECK(!is_negative(rest) && integer_compare(&w, rest, unit) < 0 && q.is_exact == is_zero(rest), "%ld: floor", n);
  }
}

static void what_is_kept_stays_the_same(void) {
  enum { KEPT = 9 };
  for (long n = 0; n < TIMES(20000); ++n) {
    workspace w = whole_workspace();
    integer kept[KEPT], copies[KEPT];
    for (int i = 0; i < 20; ++i) random_integer(&w, 200);
    for (int i = 0; i < KEPT; ++i) copies[i] = random_integer(&w, 300);
    const size_t mark = w.used;
    for (int i = 0; i < KEPT; ++i) {
      random_integer(&w, 400);
      /* Some lie before the mark, some are sums, some the same twice. */
      kept[i] = i % 3 == 0 ? copies[i] : i % 3 == 1 ? integer_sum(&w, copies[i], zero) : kept[i - 1];
      if (i % 3 == 2) copies[i] = copies[i - 1];
      if (i % 3 == 1) kept[i] = integer_difference(&w, integer_sum(&w, copies[i], kept[0]), kept[0]);
    }
    integer_keep(&w, mark, kept, KEPT);
    for (int i = 0; i < KEPT; ++i) CHECK(equal(&w, kept[i], copies[i]), "%ld: integer %d", n, i);
    size_t length = 0;
    for (int i = 0; i < KEPT; ++i) length += (size_t)integer_length(integer_magnitude(kept[i]));
    CHECK(w.used == mark + length, "%ld: %zu limbs in use, not %zu", n, w.used, mark + length);
  }
}

/* A long computation in workspaces of every size: nothing is written behind them, every loop ends, and what is not full is right. */
static void a_full_workspace_says_so(void) {
  enum { LARGEST = 600 };
  static uint32_t small[LARGEST + 8];
  int full = 0;
  for (size_t capacity = 0; capacity <= LARGEST; ++capacity) {
    const random_stream before = stream;
    memset(small, 0x55, sizeof small);
    workspace w = {.limbs = small, .capacity = capacity};
    integer x = integer_of(&w, 3), y = integer_of(&w, -5);
    const size_t mark = w.used;
    for (int step = 0; step < 40; ++step) {
      const integer sum = integer_sum(&w, x, y), product = integer_product(&w, x, sum);
      integer kept[2] = {integer_shifted(&w, product, step % 2 ? -40 : 3), integer_difference(&w, y, sum)};
      rounded_quotient(&w, product, integer_sum(&w, integer_magnitude(y), integer_of(&w, 1)), 0);
      rounded_integer(&w, kept[0], 0);
      integer_compare_products(&w, x, y, sum, product);
      integer_trailing_zeros(&w, kept[0]);
      integer_keep(&w, mark, kept, 2);
      for (int i = 0; i < 2; ++i) integer_bits(&w, kept[i]);
      x = kept[0];
      y = kept[1];
      CHECK(w.used <= capacity, "%zu of %zu limbs in use", w.used, capacity);
    }
    for (size_t i = capacity; i < LARGEST + 8; ++i)
      CHECK(small[i] == 0x55555555u, "written behind %zu limbs", capacity);
    full += w.is_full;
    stream = before;
    workspace large = whole_workspace();
    integer p = integer_of(&large, 3), q = integer_of(&large, -5);
    for (int step = 0; step < 40; ++step) {
      const integer sum = integer_sum(&large, p, q);
      p = integer_shifted(&large, integer_product(&large, p, sum), step % 2 ? -40 : 3);
      q = integer_difference(&large, q, sum);
    }
    if (w.is_full) continue;
    const scaled_double one = rounded_integer(&w, x, 0), other = rounded_integer(&large, p, 0);
    CHECK(one.mantissa == other.mantissa && one.exponent == other.exponent, "another result in %zu limbs", capacity);
  }
  CHECK(full > 5 && full < LARGEST, "%d were full", full);
}

int main(void) {
  RUN(short_integers_are_those_of_the_machine);
  RUN(long_integers_obey_their_laws);
  RUN(products_are_told_apart_in_the_last_bit);
  RUN(doubles_are_integers_times_powers_of_two);
  RUN(integers_are_rounded_to_the_nearest_double);
  RUN(quotients_are_rounded_to_the_nearest_double);
  RUN(what_is_kept_stays_the_same);
  RUN(a_full_workspace_says_so);
  return test_summary();
}
