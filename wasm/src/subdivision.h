/* jacdet on a part of the element in Bernstein form, coefficient (i,j,k) at 9i + 3j + k, and its halves: de Casteljau. */
#ifndef HL_SUBDIVISION_H
#define HL_SUBDIVISION_H

/* The coefficients on the lower and the upper half along one axis. Two levels of means, each rounded once: both are off by
   at most 2u max|bernstein| more than what they are made from. */
void halve_along(const double bernstein[27], int axis, double lower[27], double upper[27]);

double least_coefficient(const double bernstein[27]);

#endif
