/* Summed area tables of moments of depth or of its Fourier bases, in fixed point: sums that wrap around are right as
 * long as the box that is asked for has less than 2^32 itself. */
#ifndef SHARED_SUMS_H
#define SHARED_SUMS_H

#include "shared/types.h"

/* Depths of [0, 1] and their powers have 18 bits: boxes of up to 128 x 128 texels are told. */
#define SUM_ONE 262143.0 /* 2^18 - 1 */
#define SUM_BOX_MAX 128

/* Bases, of [-1, 1], have 12 bits: boxes of up to 1024 x 1024 texels, for what is compared with them is a step in K terms.
 * Tables of all maps follow each other: cos of each group of four terms, sin, a cos, a sin, and a. */
#define SUM_BASIS_ONE 4095.0

/* Invocations of a group; each adds up a row or a column. */
#define SUM_LINES 64

#endif
