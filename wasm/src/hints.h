/* Hints for what a page says of a large mesh before it knows all of it: they point to the cells which are then looked at closely. */
#ifndef HL_HINTS_H
#define HL_HINTS_H

#include "hexlens.h"

/* True if two vertices or more are at one position; knowing that the element is valid saves most of the work. */
bool has_coincident_vertices(const double vertices[HL_COORDINATES], bool is_valid);

/* False if certainly neither the corners nor VTK's scaled Jacobian accept the invalid element, given its least corner. */
bool may_be_accepted(const double vertices[HL_COORDINATES], double corner_minimum);

/* The boundary minimum over |volume| within 2^-20 of itself, from twelve times the volume and the bound's size, (L4), (L5); NaN where
   that is not certain. 0 if the minimum is: then jacdet is nowhere negative, and a volume of 0 is that of a collapsed element. */
float relative_minimum_about(double minimum, double twelvefold, double size);

#endif
