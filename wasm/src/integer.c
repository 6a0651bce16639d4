/* Schoolbook arithmetic: the integers of an ordinary element have two to twenty limbs. */
#include "integer.h"

#include <string.h>

enum { LIMB_BITS = 32 };

static uint32_t *reserved(workspace *w, size_t count) {
  if (w->is_full || count > w->capacity - w->used) {
    w->is_full = true;
    return NULL;
  }
  uint32_t *limbs = w->limbs + w->used;
  w->used += count;
  return limbs;
}

/* The limbs just reserved, without leading zeros, which are given back. */
static integer trimmed(workspace *w, uint32_t *limbs, int32_t length, bool is_negative) {
  const int32_t given = length;
  while (length > 0 && limbs[length - 1] == 0) --length;
  w->used -= (size_t)(given - length);
  const uint64_t offset = (uint64_t)(limbs - w->limbs);
  return (integer){offset << 32 | (uint32_t)(is_negative ? -length : length)};
}

static const uint32_t *limbs_of(const workspace *w, integer a) { return w->limbs + (a.place >> 32); }

static int32_t length_of(integer a) { return integer_length(integer_magnitude(a)); }

integer integer_of(workspace *w, int64_t value) {
  uint32_t *limbs = reserved(w, 2);
  if (!limbs) return zero;
  const uint64_t magnitude = value < 0 ? -(uint64_t)value : (uint64_t)value;
  limbs[0] = (uint32_t)magnitude;
  limbs[1] = (uint32_t)(magnitude >> LIMB_BITS);
  return trimmed(w, limbs, 2, value < 0);
}

integer integer_of_double(workspace *w, double x, int *exponent) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  const int biased = (int)(bits >> 52 & 0x7ff);
  uint64_t magnitude = bits & 0xfffffffffffffu;
  if (biased > 0) magnitude |= (uint64_t)1 << 52;
  *exponent = 0;
  if (magnitude == 0) return zero;
  const int zeros = __builtin_ctzll(magnitude);
  *exponent = (biased > 0 ? biased : 1) - 1075 + zeros;
  magnitude >>= zeros;
  return integer_of(w, x < 0 ? -(int64_t)magnitude : (int64_t)magnitude);
}

int integer_bits(const workspace *w, integer a) {
  const int32_t length = length_of(a);
  return length == 0 ? 0 : LIMB_BITS * length - __builtin_clz(limbs_of(w, a)[length - 1]);
}

static int compared_magnitudes(const workspace *w, integer a, integer b) {
  const uint32_t *x = limbs_of(w, a), *y = limbs_of(w, b);
  const int32_t n = length_of(a), m = length_of(b);
  if (n != m) return n < m ? -1 : 1;
  for (int32_t i = n; i-- > 0;)
    if (x[i] != y[i]) return x[i] < y[i] ? -1 : 1;
  return 0;
}

int integer_compare(const workspace *w, integer a, integer b) {
  const int sign = integer_sign(a);
  if (sign != integer_sign(b)) return sign < integer_sign(b) ? -1 : 1;
  return sign < 0 ? -compared_magnitudes(w, a, b) : compared_magnitudes(w, a, b);
}

static integer sum_of_magnitudes(workspace *w, integer a, integer b, bool is_negative) {
  int32_t n = length_of(a), m = length_of(b);
  if (n < m) {
    const integer shorter = a;
    a = b;
    b = shorter;
    n = length_of(a);
    m = length_of(b);
  }
  uint32_t *out = reserved(w, (size_t)n + 1);
  if (!out) return zero;
  const uint32_t *x = limbs_of(w, a), *y = limbs_of(w, b);
  uint64_t carry = 0;
  for (int32_t i = 0; i < n; ++i) {
    carry += (uint64_t)x[i] + (i < m ? y[i] : 0);
    out[i] = (uint32_t)carry;
    carry >>= LIMB_BITS;
  }
  out[n] = (uint32_t)carry;
  return trimmed(w, out, n + 1, is_negative);
}

/* |a| - |b| for |a| >= |b|. */
static integer difference_of_magnitudes(workspace *w, integer a, integer b, bool is_negative) {
  const int32_t n = length_of(a), m = length_of(b);
  uint32_t *out = reserved(w, (size_t)n);
  if (!out) return zero;
  const uint32_t *x = limbs_of(w, a), *y = limbs_of(w, b);
  uint64_t borrow = 0;
  for (int32_t i = 0; i < n; ++i) {
    const uint64_t difference = (uint64_t)x[i] - (i < m ? y[i] : 0) - borrow;
    out[i] = (uint32_t)difference;
    borrow = difference >> 63;
  }
  return trimmed(w, out, n, is_negative);
}

integer integer_sum(workspace *w, integer a, integer b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  const bool is_below = is_negative(a);
  if (is_below == is_negative(b)) return sum_of_magnitudes(w, a, b, is_below);
  if (compared_magnitudes(w, a, b) >= 0) return difference_of_magnitudes(w, a, b, is_below);
  return difference_of_magnitudes(w, b, a, !is_below);
}

integer integer_difference(workspace *w, integer a, integer b) { return integer_sum(w, a, integer_negated(b)); }

integer integer_product(workspace *w, integer a, integer b) {
  int32_t n = length_of(a), m = length_of(b);
  if (n == 0 || m == 0) return zero;
  if (n > m) {
    const integer longer = a;
    a = b;
    b = longer;
    n = length_of(a);
    m = length_of(b);
  }
  uint32_t *out = reserved(w, (size_t)n + (size_t)m);
  if (!out) return zero;
  const uint32_t *x = limbs_of(w, a), *y = limbs_of(w, b);
  memset(out, 0, (size_t)(n + m) * sizeof *out);
  /* Two limbs of the shorter one at a time: their carries do not wait for each other. */
  for (int32_t i = 0; i < n; i += 2) {
    const uint64_t low = x[i], high = i + 1 < n ? x[i + 1] : 0;
    uint64_t carry = 0, next_carry = 0, before = 0;
    for (int32_t j = 0; j < m; ++j) {
      const uint64_t limb = y[j];
      carry += low * limb + out[i + j];
      next_carry += high * before + (uint32_t)carry;
      out[i + j] = (uint32_t)next_carry;
      carry >>= LIMB_BITS;
      next_carry >>= LIMB_BITS;
      before = limb;
    }
    next_carry += high * before + carry;
    out[i + m] = (uint32_t)next_carry;
    if (i + 1 < n) out[i + m + 1] = (uint32_t)(next_carry >> LIMB_BITS);
  }
  ++w->multiplications;
  w->products += (uint64_t)n * (uint64_t)m;
  return trimmed(w, out, n + m, is_negative(a) != is_negative(b));
}

integer integer_times(workspace *w, integer a, int32_t factor) {
  const int32_t n = length_of(a);
  if (n == 0 || factor == 0) return zero;
  uint32_t *out = reserved(w, (size_t)n + 1);
  if (!out) return zero;
  const uint32_t *x = limbs_of(w, a);
  const uint64_t size = factor < 0 ? -(uint64_t)factor : (uint64_t)factor;
  uint64_t carry = 0;
  for (int32_t i = 0; i < n; ++i) {
    carry += size * x[i];
    out[i] = (uint32_t)carry;
    carry >>= LIMB_BITS;
  }
  out[n] = (uint32_t)carry;
  return trimmed(w, out, n + 1, is_negative(a) != (factor < 0));
}

static integer shifted_down(workspace *w, integer a, int shift) {
  const int32_t n = length_of(a), limbs = shift / LIMB_BITS, bits = shift % LIMB_BITS;
  if (n <= limbs) return zero;
  uint32_t *out = reserved(w, (size_t)(n - limbs));
  if (!out) return zero;
  const uint32_t *x = limbs_of(w, a);
  for (int32_t i = limbs; i < n; ++i) {
    const uint64_t both = x[i] | (uint64_t)(i + 1 < n ? x[i + 1] : 0) << LIMB_BITS;
    out[i - limbs] = (uint32_t)(both >> bits);
  }
  return trimmed(w, out, n - limbs, is_negative(a));
}

int integer_trailing_zeros(const workspace *w, integer a) {
  const uint32_t *x = limbs_of(w, a);
  if (is_zero(a)) return 0; /* of a full workspace */
  int i = 0;
  while (x[i] == 0) ++i;
  return LIMB_BITS * i + __builtin_ctz(x[i]);
}

integer integer_shifted(workspace *w, integer a, int shift) {
  if (shift < 0) return shifted_down(w, a, -shift);
  const int32_t n = length_of(a), limbs = shift / LIMB_BITS, bits = shift % LIMB_BITS;
  if (n == 0 || shift == 0) return a;
  uint32_t *out = reserved(w, (size_t)(n + limbs) + 1);
  if (!out) return zero;
  const uint32_t *x = limbs_of(w, a);
  memset(out, 0, (size_t)limbs * sizeof *out);
  uint64_t carry = 0;
  for (int32_t i = 0; i < n; ++i) {
    carry |= (uint64_t)x[i] << bits;
    out[i + limbs] = (uint32_t)carry;
    carry >>= LIMB_BITS;
  }
  out[n + limbs] = (uint32_t)carry;
  return trimmed(w, out, n + limbs + 1, is_negative(a));
}

/* They are put behind all that is in use, since some may lie where others are to go. Where there is no room for that they stay. */
void integer_keep(workspace *w, size_t mark, integer *kept, int count) {
  const size_t from = w->used;
  size_t length = 0;
  for (int i = 0; i < count; ++i) length += (size_t)length_of(kept[i]);
  uint32_t *copy = reserved(w, length);
  if (!copy) return;
  for (int i = 0; i < count; ++i) {
    const size_t own = (size_t)length_of(kept[i]);
    const uint64_t offset = mark + (size_t)(copy - (w->limbs + from));
    if (own > 0) memcpy(copy, limbs_of(w, kept[i]), own * sizeof *copy);
    copy += own;
    kept[i].place = offset << 32 | (uint32_t)kept[i].place;
  }
  memmove(w->limbs + mark, w->limbs + from, length * sizeof *w->limbs);
  w->used = mark + length;
}

enum { QUOTIENT_BITS = 62 };

/* Doubles in place; the limbs are as many as before, and no bit is lost. */
static void double_in_place(uint32_t *limbs, int32_t length) {
  uint32_t carry = 0;
  for (int32_t i = 0; i < length; ++i) {
    const uint32_t limb = limbs[i];
    limbs[i] = limb << 1 | carry;
    carry = limb >> (LIMB_BITS - 1);
  }
}

/* rest -= divisor if that is not negative. */
static bool subtract_in_place(uint32_t *rest, const uint32_t *divisor, int32_t length) {
  int32_t i = length - 1;
  while (i > 0 && rest[i] == divisor[i]) --i;
  if (rest[i] < divisor[i]) return false;
  uint64_t borrow = 0;
  for (i = 0; i < length; ++i) {
    const uint64_t difference = (uint64_t)rest[i] - divisor[i] - borrow;
    rest[i] = (uint32_t)difference;
    borrow = difference >> 63;
  }
  return true;
}

/* The limbs of a * 2^shift, as many as `length`, to be worked on in place. */
static uint32_t *aligned(workspace *w, integer a, int shift, int32_t length) {
  const integer moved = integer_shifted(w, integer_magnitude(a), shift);
  uint32_t *limbs = reserved(w, (size_t)length);
  if (!limbs) return NULL;
  memset(limbs, 0, (size_t)length * sizeof *limbs);
  memcpy(limbs, limbs_of(w, moved), (size_t)length_of(moved) * sizeof *limbs);
  return limbs;
}

/* Long division, bit by bit: with both as many bits, the quotient is in (1/2, 2). */
quotient_floor floor_of_quotient(workspace *w, integer numerator, integer denominator) {
  const int n = integer_bits(w, numerator), d = integer_bits(w, denominator), most = n > d ? n : d;
  const int32_t length = most / LIMB_BITS + 2; /* of a rest that is doubled */
  const size_t mark = w->used;
  uint32_t *rest = aligned(w, numerator, most - n, length), *divisor = aligned(w, denominator, most - d, length);
  quotient_floor q = {0, n - d + 1, true};
  if (!rest || !divisor) return (quotient_floor){1, 0, true};
  while (q.bits >> (QUOTIENT_BITS - 1) == 0) {
    q.bits = q.bits << 1 | subtract_in_place(rest, divisor, length);
    double_in_place(rest, length);
    --q.exponent;
  }
  for (int32_t i = 0; i < length; ++i) q.is_exact = q.is_exact && rest[i] == 0;
  w->used = mark;
  return q;
}

/* bits * 2^exponent with bits in [2^61, 2^62), of which the last stands for all that were cut off, so that it is rounded once. */
static scaled_double rounded_bits(int64_t bits, int exponent, bool is_negative) {
  const double magnitude = (double)bits * 0x1p-62;
  const bool is_one = magnitude == 1;
  return (scaled_double){(is_negative ? -1 : 1) * (is_one ? 0.5 : magnitude), exponent + QUOTIENT_BITS + is_one};
}

scaled_double rounded_integer(const workspace *w, integer a, int exponent) {
  const uint32_t *x = limbs_of(w, a);
  const int32_t length = length_of(a);
  if (length == 0) return (scaled_double){0, 0};
  const int shift = integer_bits(w, a) - QUOTIENT_BITS;
  uint64_t bits = 0;
  bool is_cut = false;
  for (int32_t i = length; i-- > 0;) {
    const int at = LIMB_BITS * i - shift; /* where the limb's lowest bit goes */
    if (at >= 0) bits |= (uint64_t)x[i] << at;
    else if (at > -LIMB_BITS) bits |= x[i] >> -at;
    is_cut = is_cut || (at < 0 && (at <= -LIMB_BITS ? x[i] : x[i] << (LIMB_BITS + at)) != 0);
  }
  return rounded_bits((int64_t)(bits | is_cut), exponent + shift, is_negative(a));
}

scaled_double rounded_quotient(workspace *w, integer numerator, integer denominator, int exponent) {
  if (is_zero(numerator)) return (scaled_double){0, 0};
  const quotient_floor q = floor_of_quotient(w, numerator, denominator);
  return rounded_bits(q.bits | !q.is_exact, exponent + q.exponent, is_negative(numerator));
}

static scaled_double product_of(scaled_double a, scaled_double b) {
  return (scaled_double){a.mantissa * b.mantissa, a.exponent + b.exponent};
}

/* Each product of two rounded integers carries three roundings: 3u of itself and terms of second order, less than 2^-51. */
int integer_compare_products(workspace *w, integer a, integer b, integer c, integer d) {
  const int sign = integer_sign(a) * integer_sign(b), other = integer_sign(c) * integer_sign(d);
  if (sign != other || sign == 0) return (sign > other) - (sign < other);
  const scaled_double x = product_of(rounded_integer(w, a, 0), rounded_integer(w, b, 0)),
                      y = product_of(rounded_integer(w, c, 0), rounded_integer(w, d, 0));
  const int apart = x.exponent - y.exponent; /* mantissas are of magnitude in [1/4, 1) */
  if (apart > 2) return sign;
  if (apart < -2) return -sign;
  const double p = times_power_of_two(x.mantissa, apart), difference = p - y.mantissa;
  const double size = p < 0 ? -p : p, error = (size + (y.mantissa < 0 ? -y.mantissa : y.mantissa)) * 0x1p-50;
  if (difference > error) return 1;
  if (difference < -error) return -1;
  return integer_compare(w, integer_product(w, a, b), integer_product(w, c, d));
}
