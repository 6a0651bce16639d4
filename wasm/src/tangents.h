/* A lower bound of jacdet by tangents, after Knabner, Korotov and Summ: docs/algorithm.md (K1) to (K4). */
#ifndef HL_TANGENTS_H
#define HL_TANGENTS_H

enum { MAX_TANGENTS = 8, REPORTED_TANGENTS = 4 };

/* A bound from coefficients off by at most `error`; positive only if jacdet certainly is. */
double tangent_bound(const double bernstein[27], double error, int tangents);

#endif
