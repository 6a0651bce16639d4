/* Every error bound, and what depends on one, with the equation of docs/algorithm.md that it comes from. Jacdets are in scaled
   units, u is UNIT_ROUNDOFF, R the greatest permanent, M = max|bernstein|; what ends in ROUNDINGS counts u. */
#ifndef HL_ERROR_BOUNDS_H
#define HL_ERROR_BOUNDS_H

/* One rounding of the doubles: half the distance from 1 to the next double. */
#define UNIT_ROUNDOFF 0x1p-53

/* (8): of a corner, and of a coefficient on a face. */
#define CORNER_ERROR (49 * UNIT_ROUNDOFF)
#define FACE_BERNSTEIN_ROUNDINGS 215
#define FACE_BERNSTEIN_ERROR (FACE_BERNSTEIN_ROUNDINGS * UNIT_ROUNDOFF)

/* (8R), in R: of a coefficient on the faces and of the cube's centre; and what products that underflow add. */
#define BOUNDARY_ERROR (36 * UNIT_ROUNDOFF)
#define CENTRE_ERROR (100 * UNIT_ROUNDOFF)
#define UNDERFLOW_ERROR 0x1p-1000

/* (F1): of a candidate's value on an edge and on a face. */
#define EDGE_ERROR (96 * UNIT_ROUNDOFF)
#define FACE_ERROR (448 * UNIT_ROUNDOFF)

/* (17): what the factors of P are off by. B and N are differences of coefficients of at most 18, a of B and N, the derivatives
   differences of these. Then the roundings of P's making. */
#define B_ROUNDINGS (2 * FACE_BERNSTEIN_ROUNDINGS + 36)
#define A_ROUNDINGS (2 * B_ROUNDINGS + 72)
#define C_SLOPE_ROUNDINGS (2 * B_ROUNDINGS)
#define B_SLOPE_ROUNDINGS (2 * A_ROUNDINGS)
#define A_SLOPE_ROUNDINGS (2 * A_ROUNDINGS + 144)
#define QUARTIC_ROUNDINGS 32

/* (F3): B and N, and what D/4 = ac - B^2 adds to the errors of its factors, when [0,1] is halved so many times. */
#define FILTER_HALVINGS 12
#define HALVED_B_ERROR (1400 * UNIT_ROUNDOFF)
#define HALVED_D_ROUNDINGS 64

/* (18): of a value by de Casteljau's scheme, for each level: 1-t, product, sum. */
#define LEVEL_ROUNDINGS 3

/* (M1), in M: of a candidate's value, and how far a face can go below its candidates. */
#define CANDIDATE_ROUNDINGS 12
#define QUARTIC_MISS_ROUNDINGS 4000

/* (M2), in R: coefficients that are all smaller have lost digits, and exact arithmetic has them. */
#define LEAST_PART_OF_PERMANENT 0x1p-5

/* (B2): clearances far above the roundings, of B and N and of D/4, when an interval is halved so many times. */
#define SKIP_HALVINGS 6
#define CLEARANCE_B 0x1p-31
#define CLEARANCE_D 0x1p-30

/* (V2), (V5), (V6), in M: of a halving along one axis, of a value by Bernstein polynomials, of the Hessian with its factors, of a
   tangent plane. */
#define PART_HALVING_ROUNDINGS 2
#define PART_VALUE_ROUNDINGS 40
#define HESSIAN_ROUNDINGS 1024
#define TANGENT_ROUNDINGS 1024

/* (L1), of floats, in prod X_r with X_r the largest coordinate on axis r relative to vertex 0: twice the error, so that what is
   beyond it is beyond the scalar code's bounds as well. It holds for sizes whose products neither overflow nor lose digits. */
#define FLOAT_ERROR (8 * 640 * 0x1p-24f)
#define LEAST_FLOAT 0x1p-30f
#define GREATEST_FLOAT 0x1p30f

/* Section 10, "Doubles": sizes for which plain doubles and powers of two do; and (M2) there, with room for the roundings
   of its permanent. */
#define LEAST_DOUBLE 0x1p-250
#define GREATEST_DOUBLE 0x1p250
#define LEAST_PART_IN_LANES (LEAST_PART_OF_PERMANENT * (1 + 0x1p-40))

/* Volumes in pairs of doubles, (V0): each of the 18 products of three carries two sums of pairs, of a column and of the minor, and up to
   eight of the total, of 3u^2 each, and two products of 8u^2: 46u^2, less than 2^-100 of the sum of their magnitudes. */
#define PAIR_ERROR 0x1p-98
/* Coordinates whose products of three neither overflow nor lose the digits of their second doubles. */
#define LEAST_COORDINATE 0x1p-250
#define GREATEST_COORDINATE 0x1p250

#endif
