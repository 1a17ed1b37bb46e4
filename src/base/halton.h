/* Halton's low-discrepancy sequence: the radical inverse of i in base 2 and 3.
 *
 * [Dong 2009 §6] samples the reflective shadow map at Halton points. The CPU generates them, so
 * that the GPU passes and the CPU reference use the very same points.
 */
#ifndef BASE_HALTON_H
#define BASE_HALTON_H

#include <stdint.h>

/* The digits of i in the base, mirrored at the radix point; in [0, 1). */
double radical_inverse(uint32_t base, uint32_t i);

#endif
