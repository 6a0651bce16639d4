/* The version with which the library was compiled. */
#include "hexlens.h"

const char *hl_version(void) { return HL_VERSION; }
