/* What reports and batches share. */
#ifndef HL_REPORT_H
#define HL_REPORT_H

#include "hexlens.h"

/* What doubles decide and know the minimum of as well; `permanent` is the greatest one, `minimum` the least candidate. */
hl_verdict accurate_verdict(const double bernstein[HL_BERNSTEIN], double permanent, double minimum);

#endif
