/* A face whose edges are positive is positive if and only if there is no t in (0,1) with beta_1(t) < 0 and
   D(t) = beta_0 beta_2 - beta_1^2 <= 0, docs/algorithm.md (X1). [0,1] is halved until coefficients say which; where D has
   roots that halving cannot separate, Sturm's theorem counts them, (X2). */
#include "exact_face.h"
#include "scaling.h"
#include "sturm.h"

#include <string.h>

/* A dyadic point or the interval behind it: t from k / 2^depth to (k + 1) / 2^depth. */
typedef struct dyadic {
  integer k;
  int depth;
} dyadic;

/* beta_i at the dyadic point, times 4^depth. */
static integer value_at(workspace *w, const integer q[3], dyadic at) {
  const integer first = integer_difference(w, q[1], q[0]), second = integer_difference(w, q[2], q[1]),
                low = integer_sum(w, integer_shifted(w, q[0], at.depth), integer_product(w, at.k, first)),
                high = integer_sum(w, integer_shifted(w, q[1], at.depth), integer_product(w, at.k, second));
  return integer_sum(w, integer_shifted(w, low, at.depth), integer_product(w, at.k, integer_difference(w, high, low)));
}

/* The coefficients on the dyadic interval, times 4^depth: polar forms at its ends. Counted from the nearer end of [0,1], k is small
   where the interval is near it. */
static void restricted(workspace *w, const integer q[3], dyadic in, integer out[3]) {
  const bool is_near_one = integer_bits(w, in.k) == in.depth && in.depth > 0;
  const int from = is_near_one ? 2 : 0, to = 2 - from;
  const integer last = integer_difference(w, integer_shifted(w, integer_of(w, 1), in.depth), integer_of(w, 1)),
                k = is_near_one ? integer_difference(w, last, in.k) : in.k,
                first = integer_difference(w, q[1], q[from]), second = integer_difference(w, q[to], q[1]),
                low = integer_sum(w, integer_shifted(w, q[from], in.depth), integer_product(w, k, first)),
                high = integer_sum(w, integer_shifted(w, q[1], in.depth), integer_product(w, k, second)),
                step = integer_difference(w, high, low);
  out[from] = integer_sum(w, integer_shifted(w, low, in.depth), integer_product(w, k, step));
  out[1] = integer_sum(w, out[from], step);
  /* The second difference of the coefficients stays what it was. */
  out[to] = integer_sum(w, integer_sum(w, out[1], step), integer_difference(w, second, first));
}

/* True if the interval is the last of its depth. */
static bool is_last(workspace *w, dyadic in) {
  const integer behind = integer_sum(w, in.k, integer_of(w, 1));
  return integer_trailing_zeros(w, behind) == in.depth;
}

/* The next dyadic interval behind this one, as long as can be; false behind the last. */
static bool next_interval(workspace *w, dyadic *in) {
  const integer k = integer_sum(w, in->k, integer_of(w, 1));
  if (w->is_full) return false;
  const int zeros = integer_trailing_zeros(w, k);
  if (zeros >= in->depth) return false;
  *in = (dyadic){integer_shifted(w, k, -zeros), in->depth - zeros};
  return true;
}

static dyadic lower_half(workspace *w, dyadic in) { return (dyadic){integer_shifted(w, in.k, 1), in.depth + 1}; }

static dyadic middle_of(workspace *w, dyadic in) {
  return (dyadic){integer_sum(w, integer_shifted(w, in.k, 1), integer_of(w, 1)), in.depth + 1};
}

static bool none_is_negative(const integer *values, int count) {
  for (int i = 0; i < count; ++i)
    if (is_negative(values[i])) return false;
  return true;
}

/* The factors of D: the nine coefficients of the face, [3 * i + j]; B = beta_1 - beta_0, and a =
   beta_2 - 2 beta_1 + beta_0 at both ends of the interval, between which it is linear. */
enum { B_0 = 9, A_0 = 12, FACTORS = 14 };

/* A coefficient of D, times a positive integer, is a sum of products of two factors. */
typedef struct term {
  signed char times;
  unsigned char x, y;
} term;
enum { MOST_TERMS = 6 };
typedef struct sum_of_products {
  int count;
  term terms[MOST_TERMS];
} sum_of_products;

/* D = beta_0 beta_2 - beta_1^2: coefficients times 1, 2, 6, 2, 1. */
static const sum_of_products by_rows[5] = {{2, {{1, 0, 6}, {-1, 3, 3}}},
                                           {3, {{1, 0, 7}, {1, 1, 6}, {-2, 3, 4}}},
                                           {5, {{1, 0, 8}, {1, 2, 6}, {4, 1, 7}, {-4, 4, 4}, {-2, 3, 5}}},
                                           {3, {{1, 1, 8}, {1, 2, 7}, {-2, 4, 5}}},
                                           {2, {{1, 2, 8}, {-1, 5, 5}}}};

/* The same as a beta_0 - B^2, times 1, 4, 6, 4, 1: where the rows are nearly alike its terms do not cancel. */
static const sum_of_products by_parabolas[5] = {
    {2, {{1, 12, 0}, {-1, 9, 9}}},
    {4, {{1, 12, 0}, {2, 12, 1}, {1, 13, 0}, {-4, 9, 10}}},
    {6, {{2, 12, 1}, {1, 13, 0}, {1, 12, 2}, {2, 13, 1}, {-4, 10, 10}, {-2, 9, 11}}},
    {4, {{1, 12, 2}, {2, 13, 1}, {1, 13, 2}, {-4, 10, 11}}},
    {2, {{1, 13, 2}, {-1, 11, 11}}}};

static integer exact_sum(workspace *w, const sum_of_products *sum, const integer factors[FACTORS]) {
  integer total = zero;
  for (int n = 0; n < sum->count; ++n) {
    const term t = sum->terms[n];
    total = integer_sum(w, total, integer_times(w, integer_product(w, factors[t.x], factors[t.y]), t.times));
  }
  return total;
}

/* A term of rounded factors carries three roundings, the sum of six terms of total magnitude A five more of at most A each, and what
   underflows is nothing beside a term of 1/4: less than 9uA. */
#define SUM_ERROR 0x1p-49

/* The sign of the sum if that is certain, else 0. */
static int certain_sign(const sum_of_products *sum, const scaled_double rounded[FACTORS]) {
  double terms[MOST_TERMS], total = 0, size = 0;
  int exponents[MOST_TERMS], greatest = INT32_MIN;
  for (int n = 0; n < sum->count; ++n) {
    const scaled_double x = rounded[sum->terms[n].x], y = rounded[sum->terms[n].y];
    terms[n] = sum->terms[n].times * (x.mantissa * y.mantissa);
    exponents[n] = x.exponent + y.exponent;
    if (terms[n] != 0 && exponents[n] > greatest) greatest = exponents[n];
  }
  for (int n = 0; n < sum->count; ++n) {
    if (terms[n] == 0 || exponents[n] - greatest < -1000) continue;
    const double value = times_power_of_two(terms[n], exponents[n] - greatest);
    total += value;
    size += value < 0 ? -value : value;
  }
  return (total > SUM_ERROR * size) - (total < -SUM_ERROR * size);
}

/* Bits: integers of ordinary elements are shorter. */
enum { LONG = 1000 };

static bool is_long(const workspace *w, const integer *values, int count) {
  for (int i = 0; i < count; ++i)
    if (integer_bits(w, values[i]) > LONG) return true;
  return false;
}

/* An interval's strip of the face, and what is made of it when it is wanted. */
typedef struct face_strip {
  integer factors[FACTORS];
  scaled_double rounded[FACTORS];
  bool has_parabolas;
} face_strip;

static void make_parabolas(workspace *w, face_strip *strip) {
  integer *f = strip->factors;
  for (int j = 0; j < 3; ++j) f[B_0 + j] = integer_difference(w, f[3 + j], f[j]);
  for (int end = 0; end < 2; ++end)
    f[A_0 + end] = integer_difference(w, integer_difference(w, f[6 + 2 * end], f[3 + 2 * end]), f[B_0 + 2 * end]);
  for (int i = B_0; i < FACTORS; ++i) strip->rounded[i] = rounded_integer(w, f[i], 0);
  strip->has_parabolas = true;
}

static int discriminant_sign(workspace *w, face_strip *strip, int i) {
  int sign = certain_sign(&by_rows[i], strip->rounded);
  if (sign != 0) return sign;
  if (!strip->has_parabolas) make_parabolas(w, strip);
  sign = certain_sign(&by_parabolas[i], strip->rounded);
  return sign != 0 ? sign : integer_sign(exact_sum(w, &by_parabolas[i], strip->factors));
}

/* True if no coefficient of D is negative. `outer` are the signs at the ends, 0 if not known. */
static bool discriminant_is_not_negative(workspace *w, face_strip *strip, int outer[2]) {
  for (int i = 0; i < 9; ++i) strip->rounded[i] = rounded_integer(w, strip->factors[i], 0);
  strip->has_parabolas = false;
  for (int end = 0; end < 2; ++end)
    if (outer[end] == 0) outer[end] = discriminant_sign(w, strip, 4 * end);
  bool is_not_negative = outer[0] >= 0 && outer[1] >= 0;
  for (int i = 1; i < 4 && is_not_negative; ++i) is_not_negative = discriminant_sign(w, strip, i) >= 0;
  return is_not_negative;
}

/* The sign of D where beta_1 < 0 on an interval at whose ends inside the face, and where beta_1 = 0, D is positive: -1, 0 or 1 for
   its least value, (X2). */
static int sign_by_roots(workspace *w, const face_strip *strip) {
  const integer *z = strip->factors + 3;
  polynomial p = {.degree = 4}, g = {.c = {z[0], integer_shifted(w, z[1], 1), z[2]}, .degree = 2}, common, ignored;
  for (int i = 0; i < 5; ++i) p.c[i] = integer_shifted(w, exact_sum(w, &by_rows[i], strip->factors), i % 2);
  lower_degree(&p);
  lower_degree(&g);
  if (p.degree < 0 || g.degree < 0) return 1;
  if ((sign_at_zero(&p) < 0 && sign_at_zero(&g) < 0) || (sign_at_infinity(&p) < 0 && sign_at_infinity(&g) < 0))
    return -1;
  const int roots = roots_with_negative(w, &p, &g, &common);
  if (roots == 0) return 1;
  return common.degree > 0 && roots_with_negative(w, &common, &g, &ignored) == roots ? 0 : -1;
}

/* Halvings before roots are counted: by then beta_1 < 0 has been parted from beta_1 >= 0 in all but rare cases. Of long integers,
   halvings cost little and counting much: about 6000 products of limbs for each pair of limbs of the coefficients. Halving ends when
   it has cost as much, so that both together cost at most twice what the better one would, and before it makes them much longer. */
enum { HALVINGS = 12, MOST_HALVINGS = 1000, PRODUCTS_OF_COUNTING = 6000 };

/* The products of limbs at which halving ends. */
static uint64_t end_of_halving(const workspace *w, const exact_face *face) {
  uint64_t limbs = 0;
  for (int i = 0; i < 9; ++i) {
    const uint64_t own = (uint64_t)integer_length(integer_magnitude(face->beta[i / 3][i % 3]));
    if (own > limbs) limbs = own;
  }
  return w->products + PRODUCTS_OF_COUNTING * limbs * limbs;
}

/* The face in a larger unit: a power of two that all coefficients have. */
static void without_common_zeros(workspace *w, const exact_face *face, exact_face *out) {
  int zeros = INT32_MAX;
  for (int i = 0; i < 9; ++i) {
    const integer own = face->beta[i / 3][i % 3];
    if (!is_zero(own) && integer_trailing_zeros(w, own) < zeros) zeros = integer_trailing_zeros(w, own);
  }
  *out = *face;
  for (int i = 0; i < 9; ++i)
    if (!is_zero(face->beta[i / 3][i % 3]))
      out->beta[i / 3][i % 3] = integer_shifted(w, face->beta[i / 3][i % 3], -zeros);
}

/* exact_face_sign for edges beta_0 and beta_2 that touch zero at ends only. */
static int sign_between_touches(workspace *w, const exact_face *given) {
  exact_face in_larger_unit;
  without_common_zeros(w, given, &in_larger_unit);
  const exact_face *face = &in_larger_unit;
  const size_t mark = w->used;
  const bool has_long = is_long(w, face->beta[0], 9);
  const uint64_t end = end_of_halving(w, face);
  dyadic in = {zero, 0};
  int least = 1;
  for (bool is_open = true; is_open && !w->is_full;) {
    face_strip strip;
    const integer *z = strip.factors + 3;
    restricted(w, face->beta[1], in, strip.factors + 3);
    bool is_settled = none_is_negative(z, 3);
    if (!is_settled) {
      int outer[2] = {0, 0};
      restricted(w, face->beta[0], in, strip.factors);
      restricted(w, face->beta[2], in, strip.factors + 6);
      is_settled = discriminant_is_not_negative(w, &strip, outer);
      if ((is_negative(z[0]) && outer[0] < 0) || (is_negative(z[2]) && outer[1] < 0)) return -1;
      if ((is_negative(z[0]) && outer[0] == 0) || (is_negative(z[2]) && outer[1] == 0)) least = 0;
    }
    if (!is_settled && (has_long ? w->products > end || in.depth == MOST_HALVINGS : in.depth == HALVINGS)) {
      const int sign = sign_by_roots(w, &strip);
      if (sign < 0) return -1;
      if (sign < least) least = sign;
      is_settled = true;
    }
    if (is_settled) is_open = next_interval(w, &in);
    else in = lower_half(w, in);
    integer_keep(w, mark, &in.k, 1);
  }
  return least;
}

/* The quadratic is a square with its root in (0,1), or touches zero there. */
static bool touches_inside(workspace *w, const integer q[3]) {
  if (!is_negative(q[1]) || !is_positive(q[0]) || !is_positive(q[2])) return false;
  return integer_compare_products(w, q[0], q[2], q[1], q[1]) == 0;
}

static bool is_zero_edge(const integer q[3]) { return is_zero(q[0]) && is_zero(q[1]) && is_zero(q[2]); }

static bool has_negative_inside(workspace *w, const integer q[3]) {
  if (is_negative(q[0]) || is_negative(q[2])) return true;
  return is_negative(q[1]) && integer_compare_products(w, q[1], q[1], q[0], q[2]) > 0;
}

/* The face on both sides of t = n / (m + n), m, n > 0, up to positive factors. */
static void cut(workspace *w, const exact_face *face, integer m, integer n, exact_face *below, exact_face *above) {
  const integer both = integer_sum(w, m, n);
  for (int i = 0; i < 3; ++i) {
    const integer *q = face->beta[i], first = integer_sum(w, integer_product(w, m, q[0]), integer_product(w, n, q[1])),
                  second = integer_sum(w, integer_product(w, m, q[1]), integer_product(w, n, q[2])),
                  between = integer_sum(w, integer_product(w, m, first), integer_product(w, n, second));
    below->beta[i][0] = integer_product(w, integer_product(w, both, both), q[0]);
    below->beta[i][1] = integer_product(w, both, first);
    below->beta[i][2] = above->beta[i][0] = between;
    above->beta[i][1] = integer_product(w, both, second);
    above->beta[i][2] = integer_product(w, integer_product(w, both, both), q[2]);
  }
}

int exact_face_sign(workspace *w, const exact_face *face) {
  const integer *edges[2] = {face->beta[0], face->beta[2]};
  /* D = -beta_1^2 if an edge is 0 throughout. */
  if (is_zero_edge(edges[0]) || is_zero_edge(edges[1])) return has_negative_inside(w, face->beta[1]) ? -1 : 1;
  for (int e = 0; e < 2; ++e) {
    if (!touches_inside(w, edges[e])) continue;
    exact_face below, above;
    cut(w, face, integer_negated(edges[e][1]), edges[e][0], &below, &above);
    const int sign = exact_face_sign(w, &below), other = sign < 0 ? sign : exact_face_sign(w, &above);
    return other < sign ? other : sign;
  }
  return sign_between_touches(w, face);
}

/* bits * 2^exponent. */
typedef struct floor_value {
  int64_t bits;
  int exponent;
} floor_value;

/* The search for values below a floor that stays just below the least value found, or where it is. */
typedef struct face_search {
  workspace *w;
  const exact_face *face;
  least_value *least;
  floor_value floor;
  int wait, lowered_at; /* halvings until it is lowered the next time, and the depth then */
  bool is_fixed, has_lowered;
} face_search;

/* Halvings after which the floor is lowered, when it may be the face's minimum: no strip where that
   is touched would ever be above it. Each time there are twice as many until the next. */
enum { PATIENCE = 64 };

/* Below `least` by at least 2^-62 and at most 2^-60 of it. */
static void set_floor(face_search *s, int depth) {
  const integer numerator = s->least->numerator;
  s->floor = (floor_value){0, 0};
  s->wait = PATIENCE;
  s->lowered_at = depth + PATIENCE;
  if (is_zero(numerator)) return;
  const quotient_floor q = floor_of_quotient(s->w, numerator, s->least->denominator);
  s->floor = (floor_value){is_negative(numerator) ? -(q.bits + 2) : q.bits - 1, q.exponent};
}

/* The floor falls by at most 2^-61 of it, in depths of less than 2^14 by 2^-58 in all. */
static void lower_floor(face_search *s) {
  s->floor.bits -= s->floor.bits != 0;
  s->wait *= 2;
  s->lowered_at += s->wait;
}

/* 2^scale * a and 2^scale * floor * b, the same scale >= 0 making integers of both. */
static integer over_floor(workspace *w, integer a, floor_value floor) {
  return floor.exponent < 0 ? integer_shifted(w, a, -floor.exponent) : a;
}
static integer floor_times(workspace *w, floor_value floor, integer b) {
  const integer product = integer_product(w, integer_of(w, floor.bits), b);
  return floor.exponent > 0 ? integer_shifted(w, product, floor.exponent) : product;
}

double inside_unit_interval(workspace *w, integer numerator, integer denominator, int exponent) {
  const scaled_double x = rounded_quotient(w, numerator, denominator, exponent);
  if (x.exponent > 0) return 1 - 0x1p-53;
  return x.exponent < -1073 ? 0x1p-1074 : times_power_of_two(x.mantissa, x.exponent);
}

/* Looks at the vertex of the parabola in s at a dyadic t, if it is inside: its value is D / (beta_0 - 2 beta_1 + beta_2). */
static void look_at(face_search *s, dyadic t) {
  workspace *w = s->w;
  const integer x = value_at(w, s->face->beta[0], t), z = value_at(w, s->face->beta[1], t),
                y = value_at(w, s->face->beta[2], t), fall = integer_difference(w, x, z),
                rise = integer_difference(w, y, z);
  if (!is_positive(fall) || !is_positive(rise)) return;
  const integer numerator = integer_difference(w, integer_product(w, x, y), integer_product(w, z, z)),
                curvature = integer_sum(w, fall, rise), denominator = integer_shifted(w, curvature, 2 * t.depth);
  const integer one = integer_of(w, 1);
  const int order =
      s->is_fixed ? integer_compare_products(w, numerator, s->least->denominator, s->least->numerator, denominator)
                  : integer_compare_products(w, over_floor(w, numerator, s->floor), one,
                                             floor_times(w, s->floor, denominator), one);
  if (order >= 0) return;
  *s->least = (least_value){numerator, denominator, inside_unit_interval(w, fall, curvature, 0),
                            inside_unit_interval(w, t.k, integer_of(w, 1), -t.depth)};
  s->has_lowered = true;
  if (!s->is_fixed) set_floor(s, t.depth);
}

/* True if the face is certainly not below the floor on the interval: (X1), (X2) for f - floor. */
static bool is_above_floor(const face_search *s, dyadic in, bool counts_roots) {
  workspace *w = s->w;
  const integer floor = floor_times(w, s->floor, integer_shifted(w, integer_of(w, 1), 2 * in.depth));
  face_strip strip;
  for (int row = 0; row < 3; ++row) {
    const int i = (row + 1) % 3; /* the middle one first */
    integer *q = strip.factors + 3 * i;
    restricted(w, s->face->beta[i], in, q);
    for (int j = 0; j < 3; ++j) q[j] = integer_difference(w, over_floor(w, q[j], s->floor), floor);
    if (i == 1 && none_is_negative(q, 3)) return true;
  }
  /* The edges are above the floor at 0 and 1, perhaps by little: D > 0 where beta_1 < 0. */
  const bool edges_are_above = s->floor.bits != 0, is_last_one = is_last(w, in);
  int outer[2] = {edges_are_above && is_zero(in.k) && is_negative(strip.factors[3]),
                  edges_are_above && is_last_one && is_negative(strip.factors[5])};
  return discriminant_is_not_negative(w, &strip, outer) || (counts_roots && sign_by_roots(w, &strip) >= 0);
}

/* Halvings after which roots are counted once: where there are none below a floor that is near enough, that is cheaper than to go on. */
enum { HALVINGS_ABOVE_FLOOR = 6 };

enum { NO_LIMIT = INT32_MAX };

/* Halves [0,1] until every strip is above the floor, or as often as given, and lowers `least` on
   the way. */
static void search_halves(face_search *s, int depth_limit) {
  workspace *w = s->w;
  const size_t mark = w->used;
  const bool counts_roots = depth_limit == NO_LIMIT && !s->is_fixed && !is_long(w, s->face->beta[0], 9);
  dyadic in = {zero, 0};
  for (bool is_open = true; is_open && !w->is_full;) {
    if (in.depth == depth_limit || is_above_floor(s, in, counts_roots && in.depth == HALVINGS_ABOVE_FLOOR)) {
      is_open = next_interval(w, &in);
    } else {
      look_at(s, middle_of(w, in));
      in = lower_half(w, in);
      if (!s->is_fixed && in.depth == s->lowered_at) lower_floor(s);
    }
    integer kept[3] = {in.k, s->least->numerator, s->least->denominator};
    integer_keep(w, mark, kept, 3);
    in.k = kept[0];
    s->least->numerator = kept[1];
    s->least->denominator = kept[2];
  }
}

static void look_at_roots(face_search *s, const double *roots, int count) {
  for (int r = 0; r < count; ++r) {
    int exponent;
    const integer k = integer_of_double(s->w, roots[r], &exponent);
    look_at(s, (dyadic){k, -exponent});
  }
}

bool exact_face_lowers(workspace *w, const exact_face *face, const double *roots, int root_count, least_value *least) {
  face_search s = {.w = w, .face = face, .least = least};
  set_floor(&s, 0);
  look_at_roots(&s, roots, root_count);
  /* Nothing is relative to 0: a negative value has to be found first, which somewhere there is. */
  for (int limit = 8; is_zero(least->numerator) && !w->is_full; limit *= 2) search_halves(&s, limit);
  search_halves(&s, NO_LIMIT);
  return s.has_lowered;
}

/* Bits below the largest coefficient of a value at the point where a face touches zero. */
enum { TOUCH_BITS = 64 };

static bool is_at_most(workspace *w, const least_value *least, int exponent) {
  const integer numerator = exponent < 0 ? integer_shifted(w, least->numerator, -exponent) : least->numerator,
                denominator = exponent > 0 ? integer_shifted(w, least->denominator, exponent) : least->denominator;
  return integer_compare(w, numerator, denominator) <= 0;
}

/* A floor that is too high hides the place, and another one may have been found before: then it is lowered. */
void exact_face_touch(workspace *w, const exact_face *face, const double *roots, int root_count, least_value *least) {
  int bits = 0;
  for (int i = 0; i < 9; ++i) {
    const int own = integer_bits(w, face->beta[i / 3][i % 3]);
    if (own > bits) bits = own;
  }
  face_search s = {.w = w, .face = face, .least = least, .is_fixed = true};
  *least = (least_value){.numerator = integer_of(w, 1), .denominator = zero}; /* infinite */
  look_at_roots(&s, roots, root_count);
  const int near = bits - TOUCH_BITS;
  for (int below = TOUCH_BITS + 2; !w->is_full && !is_at_most(w, least, near); below *= 2) {
    s.floor = (floor_value){-1, bits - below};
    search_halves(&s, NO_LIMIT);
  }
}
