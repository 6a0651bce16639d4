/* Real roots of a quartic by Algorithm 1010 (Orellana and De Michele, ACM TOMS 46(2), 2020). */
#ifndef BENCH_QUARTIC_H
#define BENCH_QUARTIC_H

/* Real roots of c[0] + c[1] t + ... + c[4] t^4, lower degrees too; returns how many, in no order. The zero polynomial has none. */
int real_roots(const double c[5], double roots[4]);

#endif
