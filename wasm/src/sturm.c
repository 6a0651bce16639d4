/* Chains of remainders without divisions: their numbers grow, and are few. */
#include "sturm.h"

void lower_degree(polynomial *p) {
  while (p->degree >= 0 && is_zero(p->c[p->degree])) --p->degree;
}

int sign_at_zero(const polynomial *p) {
  int i = 0;
  while (i < p->degree && is_zero(p->c[i])) ++i;
  return integer_sign(p->c[i]);
}

int sign_at_infinity(const polynomial *p) { return integer_sign(p->c[p->degree]); }

static polynomial derivative(workspace *w, const polynomial *p) {
  polynomial d = {.degree = p->degree - 1};
  for (int i = 0; i <= d.degree; ++i) d.c[i] = integer_times(w, p->c[i + 1], i + 1);
  return d;
}

static polynomial product_of(workspace *w, const polynomial *p, const polynomial *q) {
  polynomial out = {.degree = p->degree + q->degree};
  for (int i = 0; i <= out.degree; ++i) out.c[i] = zero;
  for (int i = 0; i <= p->degree; ++i)
    for (int j = 0; j <= q->degree; ++j)
      out.c[i + j] = integer_sum(w, out.c[i + j], integer_product(w, p->c[i], q->c[j]));
  return out;
}

/* The remainder of p by q, which is not 0, times a positive factor. */
static polynomial remainder_of(workspace *w, const polynomial *p, const polynomial *q) {
  polynomial rest = *p;
  const integer lead = q->c[q->degree], size = integer_magnitude(lead);
  while (rest.degree >= q->degree && !w->is_full) {
    const int shift = rest.degree - q->degree;
    const integer factor = is_negative(lead) ? integer_negated(rest.c[rest.degree]) : rest.c[rest.degree];
    for (int i = 0; i < rest.degree; ++i) {
      rest.c[i] = integer_product(w, rest.c[i], size);
      if (i >= shift) rest.c[i] = integer_difference(w, rest.c[i], integer_product(w, q->c[i - shift], factor));
    }
    --rest.degree;
    lower_degree(&rest);
  }
  return rest;
}

/* The changes of sign near 0 less those towards infinity in the chain p, q, and on with negated remainders. `last` becomes the last
   that is not 0, a greatest common divisor. */
static int lost_changes(workspace *w, polynomial p, polynomial q, polynomial *last) {
  int lost = 0;
  while (q.degree >= 0 && !w->is_full) {
    lost += (sign_at_zero(&p) != sign_at_zero(&q)) - (sign_at_infinity(&p) != sign_at_infinity(&q));
    polynomial rest = remainder_of(w, &p, &q);
    for (int i = 0; i <= rest.degree; ++i) rest.c[i] = integer_negated(rest.c[i]);
    p = q;
    q = rest;
  }
  *last = p;
  return lost;
}

static bool none_is_positive(const polynomial *p) {
  for (int i = 0; i <= p->degree; ++i)
    if (is_positive(p->c[i])) return false;
  return true;
}

int roots_with_negative(workspace *w, const polynomial *p, const polynomial *g, polynomial *common) {
  const polynomial slope = derivative(w, p);
  const int all = lost_changes(w, *p, slope, common);
  if (all == 0 || none_is_positive(g)) return all;
  const polynomial query = product_of(w, &slope, g), reduced = remainder_of(w, &query, p);
  polynomial ignored;
  return (all - lost_changes(w, *p, reduced, &ignored)) / 2;
}
