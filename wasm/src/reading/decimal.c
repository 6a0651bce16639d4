/*
 * The double nearest to a decimal number: w * 5^q * 2^q with 64 bits of w and 128 of 5^q, as D. Lemire does it ("Number parsing at a
 * gigabyte per second", 2021, after M. Eisel), with an interval in place of his tables of cases: the product with a truncated power
 * is a lower bound, and the interval above it that has the true value either lies on one side of the middle of two doubles, or
 * long integers compare.
 */
#include "decimal.h"

#include <stddef.h>
#include <string.h>

enum {
  LEAST_POWER = -342, /* 10^19 * 10^-343 is below half of the least double */
  MOST_POWER = 308,
  EXACT_POWER = 55, /* 5^55 is the last that 128 bits hold */
  MOST_LEADING = 19,
  MOST_DIGITS_OF_EXACT = 17,
  LARGEST_EXPONENT = 100000
};

/* 5^q is (high * 2^64 + low + [0, 1)) * 2^(exponent - 127): the first 128 bits, exact for 0 <= q <= EXACT_POWER. */
typedef struct power {
  uint64_t high, low;
  int32_t exponent;
} power;

static power powers[MOST_POWER - LEAST_POWER + 1];

static const double POWERS_OF_TEN[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                       1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/*
 * Long integers that are not negative, least word first. Of a number at most MOST_DIGITS digits are kept, 2658 bits; in both
 * products that are compared the larger side is then below 10^800 * 2^64, and 5^1142 * 2^54 * 2^128, so that 96 words are enough.
 */
enum { WORDS = 128, MOST_DIGITS = 800 };

typedef struct integer {
  uint32_t words[WORDS];
  int length;
} integer;

static void multiply_add(integer *a, uint32_t factor, uint32_t more) {
  uint64_t carry = more;
  for (int i = 0; i < a->length; ++i) {
    carry += (uint64_t)a->words[i] * factor;
    a->words[i] = (uint32_t)carry;
    carry >>= 32;
  }
  if (carry != 0) a->words[a->length++] = (uint32_t)carry;
}

/* Rounded down. */
static void divide(integer *a, uint32_t divisor) {
  uint64_t rest = 0;
  for (int i = a->length - 1; i >= 0; --i) {
    rest = rest << 32 | a->words[i];
    a->words[i] = (uint32_t)(rest / divisor);
    rest %= divisor;
  }
  while (a->length > 0 && a->words[a->length - 1] == 0) --a->length;
}

static void multiply_by_power_of_five(integer *a, int power_of_five) {
  enum { FIVE_TO_13 = 1220703125 };
  for (; power_of_five >= 13; power_of_five -= 13) multiply_add(a, FIVE_TO_13, 0);
  for (; power_of_five > 0; --power_of_five) multiply_add(a, 5, 0);
}

static void shift_left(integer *a, int bits) {
  for (; bits >= 31; bits -= 31) multiply_add(a, UINT32_C(1) << 31, 0);
  multiply_add(a, UINT32_C(1) << bits, 0);
}

static int compare(const integer *a, const integer *b) {
  if (a->length != b->length) return a->length < b->length ? -1 : 1;
  for (int i = a->length - 1; i >= 0; --i)
    if (a->words[i] != b->words[i]) return a->words[i] < b->words[i] ? -1 : 1;
  return 0;
}

static int bit_length(const integer *a) { return 32 * a->length - __builtin_clz(a->words[a->length - 1]); }

/* Bits [from, from + 64) of a; those below 0 are 0. */
static uint64_t bits_from(const integer *a, int from) {
  uint64_t bits = 0;
  for (int i = 0; i < 64; ++i) {
    const int at = from + i;
    if (at >= 0 && at < 32 * a->length) bits |= (uint64_t)(a->words[at / 32] >> at % 32 & 1) << i;
  }
  return bits;
}

static power power_of(const integer *a, int scale) {
  const int length = bit_length(a);
  return (power){bits_from(a, length - 64), bits_from(a, length - 128), length - 1 - scale};
}

void hl_start_decimals(void) {
  integer five = {{1}, 1};
  for (int q = 0; q <= MOST_POWER; ++q) {
    powers[q - LEAST_POWER] = power_of(&five, 0);
    multiply_add(&five, 5, 0);
  }
  /* floor(floor(a / 5) / 5) = floor(a / 25), so that the first bits of 2^1024 / 5^k are right: it has 128 and more, as 5^342 < 2^795. */
  enum { SCALE = 1024 };
  integer fraction = {{0}, SCALE / 32 + 1};
  fraction.words[SCALE / 32] = 1;
  for (int q = -1; q >= LEAST_POWER; --q) {
    divide(&fraction, 5);
    powers[q - LEAST_POWER] = power_of(&fraction, SCALE);
  }
}

static inline bool is_digit(uint8_t byte) { return (uint8_t)(byte - '0') < 10; }

static inline uint64_t eight_bytes(const uint8_t *at) {
  uint64_t bytes;
  memcpy(&bytes, at, sizeof bytes);
  return bytes;
}

/* A digit is 0x30 to 0x39: its high half is 3, also after 6 has been added. Carries of bytes that are none stay harmless. */
static inline bool are_eight_digits(uint64_t bytes) {
  const uint64_t high = UINT64_C(0xf0f0f0f0f0f0f0f0);
  return ((bytes & high) | ((bytes + UINT64_C(0x0606060606060606)) & high) >> 4) == UINT64_C(0x3333333333333333);
}

/* The first digit is in the least byte: neighbours are joined to numbers of two, of four and of eight digits. */
static inline uint64_t value_of_eight(uint64_t bytes) {
  bytes -= UINT64_C(0x3030303030303030);
  bytes = bytes * 10 + (bytes >> 8);
  const uint64_t pairs = UINT64_C(0x000000ff000000ff);
  return ((bytes & pairs) * (100 + (UINT64_C(1000000) << 32)) +
          (bytes >> 16 & pairs) * (1 + (UINT64_C(10000) << 32))) >>
         32;
}

static inline const uint8_t *add_digits(const uint8_t *at, const uint8_t *end, uint64_t *value) {
  uint64_t sum = *value;
  while (end - at >= 8) {
    const uint64_t bytes = eight_bytes(at);
    if (!are_eight_digits(bytes)) break;
    sum = sum * 100000000 + value_of_eight(bytes);
    at += 8;
  }
  for (; at < end && is_digit(*at); ++at) sum = 10 * sum + (uint64_t)(*at - '0');
  *value = sum;
  return at;
}

/* More digits than `leading` has room for. */
static void take_leading(hl_decimal *number) {
  uint64_t leading = 0;
  int taken = 0;
  int dropped = 0;
  int behind_point = 0;
  bool has_point = false;
  for (const uint8_t *at = number->first; at < number->last; ++at) {
    if (*at == '.') {
      has_point = true;
      continue;
    }
    if (has_point) ++behind_point;
    if (taken == 0 && *at == '0') continue;
    if (taken < MOST_LEADING) {
      leading = 10 * leading + (uint64_t)(*at - '0');
      ++taken;
    } else {
      ++dropped;
      if (*at != '0') number->has_more = true;
    }
  }
  number->leading = leading;
  number->exponent = number->stated + dropped - behind_point;
}

const uint8_t *hl_scan_decimal(const uint8_t *at, const uint8_t *end, bool has_bare_exponents, hl_decimal *number) {
  number->is_negative = at < end && *at == '-';
  if (at < end && (*at == '-' || *at == '+')) ++at;
  const uint8_t *first = at;
  uint64_t leading = 0;
  at = add_digits(at, end, &leading);
  int count = (int)(at - first);
  int behind_point = 0;
  bool is_whole = true;
  if (at < end && *at == '.') {
    const uint8_t *point = ++at;
    at = add_digits(at, end, &leading);
    behind_point = (int)(at - point);
    count += behind_point;
    is_whole = false;
  }
  if (count == 0) return NULL;
  number->first = first;
  number->last = at;
  number->has_more = false;
  number->stated = 0;
  if (at < end) {
    const uint8_t letter = *at | 32;
    const bool has_letter = letter == 'e' || letter == 'd';
    if (has_letter || (has_bare_exponents && (*at == '-' || *at == '+'))) {
      if (has_letter) ++at;
      const bool is_down = at < end && *at == '-';
      if (at < end && (*at == '-' || *at == '+')) ++at;
      const uint8_t *digits = at;
      int32_t exponent = 0;
      for (; at < end && is_digit(*at); ++at)
        if (exponent < LARGEST_EXPONENT) exponent = 10 * exponent + (*at - '0');
      if (at == digits) return NULL;
      number->stated = is_down ? -exponent : exponent;
      is_whole = false;
    }
  }
  number->is_whole = is_whole;
  number->leading = leading;
  number->exponent = number->stated - behind_point;
  const uint8_t *significant = first;
  while (significant < number->last && (*significant == '0' || *significant == '.')) {
    if (*significant == '0') --count;
    ++significant;
  }
  number->digits = count;
  if (count > MOST_LEADING) take_leading(number);
  return at;
}

typedef struct product {
  uint64_t high, low;
} product;

static inline product multiply(uint64_t a, uint64_t b) {
  const uint64_t a0 = (uint32_t)a, a1 = a >> 32, b0 = (uint32_t)b, b1 = b >> 32;
  const uint64_t low = a0 * b0, mixed = a1 * b0 + (low >> 32);
  const uint64_t middle = a0 * b1 + (uint32_t)mixed;
  return (product){a1 * b1 + (mixed >> 32) + (middle >> 32), middle << 32 | (uint32_t)low};
}

/* A number between the doubles mantissa * 2^exponent and (mantissa + 1) * 2^exponent. */
typedef enum side { BELOW_MIDDLE, MIDDLE, ABOVE_MIDDLE, UNCERTAIN } side;
typedef struct place {
  uint64_t mantissa;
  int32_t exponent;
  side side;
} place;

static const place ZERO = {0, -1074, BELOW_MIDDLE};
static const place INFINITE = {UINT64_C(1) << 53, 971, BELOW_MIDDLE};

/*  Takes w * 10^q, w > 0. With w shifted to 64 bits and c the first 128 bits of 5^q, the true value
 * is X * 2^e, where X = w (c + [0, 1)) / 2^128. The high words of w * (c's high word) say X up to
 * [0, 2), all words up to 2^-63. */
static place place_of(uint64_t w, int32_t q) {
  if (q < LEAST_POWER) return ZERO;
  if (q > MOST_POWER) return INFINITE;
  const power *five = &powers[q - LEAST_POWER];
  const int zeros = __builtin_clzll(w);
  w <<= zeros;
  const int32_t e = 128 + five->exponent - 127 + q - zeros;
  product x = multiply(w, five->high);
  for (bool is_whole = false;; is_whole = true) {
    const int top = 63 - __builtin_clzll(x.high);
    int shift = top - 52;
    const int32_t exponent = top + e;
    if (exponent > 1023) return INFINITE;
    if (exponent < -1022) shift += -1022 - exponent;
    if (shift > 64) return ZERO;
    const uint64_t half = UINT64_C(1) << (shift - 1);
    const uint64_t rest = shift == 64 ? x.high : x.high & (2 * half - 1);
    place found = {shift == 64 ? 0 : x.high >> shift, e + shift, BELOW_MIDDLE};
    if (rest > half) found.side = ABOVE_MIDDLE;
    else if (rest == half && is_whole) {
      /* A power that is not exact was truncated, so that the value is more. */
      const bool is_exact = q >= 0 && q <= EXACT_POWER;
      found.side = is_exact && x.low == 0 && w * five->low == 0 ? MIDDLE : ABOVE_MIDDLE;
    } else if (rest == half - 1 && is_whole && x.low == UINT64_MAX && !(q >= 0 && q <= EXACT_POWER))
      found.side = UNCERTAIN;
    else if ((rest == half || rest == half - 1) && !is_whole) {
      const product more = multiply(w, five->low);
      x.low += more.high;
      if (x.low < more.high) ++x.high;
      continue;
    }
    return found;
  }
}

static double double_at(place number) {
  uint64_t mantissa = number.mantissa;
  if (number.side == ABOVE_MIDDLE || (number.side == MIDDLE && (mantissa & 1) == 1)) ++mantissa;
  /* A mantissa that has become 2^53 carries into the exponent, and one that has become 2^52 makes a normal double. */
  const uint64_t hidden = UINT64_C(1) << 52;
  const uint64_t bits = mantissa < hidden ? mantissa : ((uint64_t)(number.exponent + 1075) << 52) + (mantissa - hidden);
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

/* The side of (2 mantissa + 1) * 2^(exponent - 1) on which the number is, by long integers. */
static side exact_side(const hl_decimal *number, place lower) {
  integer left = {{0}, 0};
  int taken = 0;
  int32_t power_of_ten = number->stated;
  bool has_point = false;
  bool has_more = false;
  for (const uint8_t *at = number->first; at < number->last; ++at) {
    if (*at == '.') {
      has_point = true;
      continue;
    }
    if (taken < MOST_DIGITS) {
      multiply_add(&left, 10, (uint32_t)(*at - '0'));
      if (left.length > 0) ++taken;
      if (has_point) --power_of_ten;
    } else {
      if (*at != '0') has_more = true;
      if (!has_point) ++power_of_ten;
    }
  }
  const uint64_t middle = 2 * lower.mantissa + 1;
  integer right = {{(uint32_t)middle, (uint32_t)(middle >> 32)}, middle >> 32 != 0 ? 2 : 1};
  multiply_by_power_of_five(power_of_ten < 0 ? &right : &left, power_of_ten < 0 ? -power_of_ten : power_of_ten);
  const int32_t shift = power_of_ten - (lower.exponent - 1);
  if (shift > 0) shift_left(&left, shift);
  if (shift < 0) shift_left(&right, -shift);
  const int order = compare(&left, &right);
  return order < 0 ? BELOW_MIDDLE : order > 0 || has_more ? ABOVE_MIDDLE : MIDDLE;
}

static double size_of(const hl_decimal *number) {
  const uint64_t w = number->leading;
  const int32_t q = number->exponent;
  if (w == 0) return 0;
  /* Both operands are doubles: the operation rounds rightly. */
  if (w <= UINT64_C(1) << 53 && q >= -22 && q <= 22 && !number->has_more)
    return q < 0 ? (double)w / POWERS_OF_TEN[-q] : (double)w * POWERS_OF_TEN[q];
  place lower = place_of(w, q);
  if (number->has_more && lower.side != UNCERTAIN) {
    /* The number is between w and w + 1: both must become the same double. */
    const place upper = place_of(w + 1, q);
    if (lower.side == MIDDLE) lower.side = ABOVE_MIDDLE;
    if (upper.side == UNCERTAIN || upper.side == MIDDLE || double_at(lower) != double_at(upper)) lower.side = UNCERTAIN;
  }
  if (lower.side == UNCERTAIN) lower.side = exact_side(number, lower);
  return double_at(lower);
}

double hl_double_of(const hl_decimal *number) {
  const double size = size_of(number);
  return number->is_negative ? -size : size;
}

bool hl_is_exact(const hl_decimal *number) {
  uint64_t w = number->leading;
  if (w == 0) return true;
  if (number->digits >= MOST_DIGITS_OF_EXACT) return false;
  for (int32_t q = number->exponent; q < 0; ++q) {
    if (w % 5 != 0) return false;
    w /= 5;
  }
  return true;
}
