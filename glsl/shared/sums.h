/* Summed area tables of moments of depth, in fixed point: sums that wrap around are right as long as the box
 * that is asked for has less than 2^32 itself. */
#ifndef SHARED_SUMS_H
#define SHARED_SUMS_H

#include "shared/types.h"

/* Depths of [0, 1] and their powers have so many bits: boxes of up to 128 x 128 texels are told. */
#define SUM_BITS 18
#define SUM_ONE 262143.0 /* 2^SUM_BITS - 1 */
#define SUM_BOX_MAX 128

/* Invocations of a group; each adds up a row or a column. */
#define SUM_LINES 64

#endif
