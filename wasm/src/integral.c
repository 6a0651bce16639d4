/* The integral of jacdet, the element's volume, rounded to the nearest double: docs/algorithm.md (V0). In pairs of doubles, of
   which the second holds what the first was rounded by; in integers where that does not tell which double is nearest. */
#include "error_bounds.h"
#include "exact.h"
#include "report.h"
#include "topology.h"

#include <math.h>

/* Twelve times the volume is the sum of three determinants (Grandy, Efficient computation of volume of hexahedral cells, 1997):
   their columns are these differences of vertices, each the last of a pair less its first, or the sum of two. */
const unsigned char volume_columns[3][3][2][2] = {{{{1, 6}, {0, 7}}, {{3, 6}}, {{0, 2}}},
                                                  {{{0, 7}}, {{3, 6}, {0, 5}}, {{4, 6}}},
                                                  {{{1, 6}}, {{0, 5}}, {{4, 6}, {0, 2}}}};

/* high + low, high the double nearest to it. */
typedef struct pair {
  double high, low;
} pair;

/* The sum of two doubles, exactly (Knuth), and their product, exactly (Dekker, by halves of 26 bits). */
static pair exact_sum(double a, double b) {
  const double sum = a + b, b_part = sum - a;
  return (pair){sum, (a - (sum - b_part)) + (b - b_part)};
}

static double high_half(double a) {
  const double c = 134217729 * a; /* 2^27 + 1 */
  return c - (c - a);
}

static pair exact_product(double a, double b) {
  const double product = a * b, a1 = high_half(a), a2 = a - a1, b1 = high_half(b), b2 = b - b1;
  return (pair){product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

static pair renewed(double high, double low) {
  const double sum = high + low;
  return (pair){sum, low - (sum - high)};
}

static pair sum_of(pair a, pair b) {
  const pair high = exact_sum(a.high, b.high), low = exact_sum(a.low, b.low);
  const pair first = renewed(high.high, high.low + low.high);
  return renewed(first.high, first.low + low.low);
}

static pair product_of(pair a, pair b) {
  const pair high = exact_product(a.high, b.high);
  return renewed(high.high, high.low + (a.high * b.low + a.low * b.high));
}

static pair negated(pair a) { return (pair){-a.high, -a.low}; }

static void column_of(const double vertices[24], const unsigned char pairs[2][2], pair out[3]) {
  for (int r = 0; r < 3; ++r) {
    out[r] = exact_sum(vertices[3 * pairs[0][1] + r], -vertices[3 * pairs[0][0] + r]);
    if (pairs[1][0] == pairs[1][1]) continue;
    out[r] = sum_of(out[r], exact_sum(vertices[3 * pairs[1][1] + r], -vertices[3 * pairs[1][0] + r]));
  }
}

static bool are_ordinary(const double vertices[24]) {
  for (int i = 0; i < 24; ++i) {
    const double size = fabs(vertices[i]);
    if (size > GREATEST_COORDINATE || (size < LEAST_COORDINATE && size != 0)) return false;
  }
  return true;
}

/* True if the pair tells which double is nearest to the volume. */
static bool is_found_in_pairs(const double vertices[24], double *volume) {
  if (!are_ordinary(vertices)) return false;
  pair total = {0, 0};
  double size = 0;
  for (int d = 0; d < 3; ++d) {
    pair a[3], b[3], c[3];
    column_of(vertices, volume_columns[d][0], a);
    column_of(vertices, volume_columns[d][1], b);
    column_of(vertices, volume_columns[d][2], c);
    for (int r = 0; r < 3; ++r) {
      const int s = (r + 1) % 3, t = (r + 2) % 3;
      const pair minor = sum_of(product_of(a[s], b[t]), negated(product_of(a[t], b[s])));
      total = sum_of(total, product_of(minor, c[r]));
      size += (fabs(a[s].high) * fabs(b[t].high) + fabs(a[t].high) * fabs(b[s].high)) * fabs(c[r].high);
    }
  }
  /* total / 12: the quotient, and what is left of it. */
  const double quotient = total.high / 12;
  const pair product = exact_product(quotient, 12);
  const double rest = ((total.high - product.high) - product.low + total.low) / 12;
  const pair result = renewed(quotient, rest);
  const double error = size * PAIR_ERROR + fabs(result.high) * PAIR_ERROR;
  *volume = result.high;
  return result.high + (result.low + 2 * error) == result.high && result.high + (result.low - 2 * error) == result.high;
}

scaled_double find_volume(const double vertices[24]) {
  double volume;
  if (!is_found_in_pairs(vertices, &volume)) return find_exact_volume(vertices);
  if (volume == 0) return (scaled_double){0, 0};
  const int exponent = binary_exponent(volume);
  return (scaled_double){times_power_of_two(volume, -exponent), exponent};
}
