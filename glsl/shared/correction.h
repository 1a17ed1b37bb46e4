/* passes/gather/correction.h to its shaders. */
#ifndef SHARED_CORRECTION_H
#define SHARED_CORRECTION_H

#include "shared/types.h"

#define UNIT_CORRECTION_TESTS (UNIT_OWN + 0)
#define UNIT_CORRECTION_SUMS (UNIT_OWN + 1)
#define UNIT_CORRECTION_SQUARES (UNIT_OWN + 2)
#define UNIT_CORRECTION_VAL_SUMS (UNIT_OWN + 3)
#define UNIT_CORRECTION_VAL_SQUARES (UNIT_OWN + 4)

#define CORRECTION_SIDE 8      /* cells of the picture, along either side */
#define CORRECTION_TOGETHER 16 /* VPLs, of which one is tested for all */

struct correction_params {
    int tests_of_cell;
    int vpl_count;
    int groups; /* of VPLs */
    int block;  /* of blocks that share visibility, pixels a side; 0: none do */
};
PASS_BLOCK(correction_params, 16)

#endif
