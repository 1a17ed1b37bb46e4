/* Halton's low-discrepancy sequence: radical inverses of i in base 2 and 3.
 *
 * [Dong 2009 §6] samples the reflective shadow map at Halton points. The CPU generates them, so
 * GPU passes and the CPU reference use equal points. */
#ifndef BASE_HALTON_H
#define BASE_HALTON_H

#include <stdint.h>

/* Returns the digits of i in the base, mirrored at the radix point, in [0, 1). */
double radical_inverse(uint32_t base, uint32_t i);

#endif
