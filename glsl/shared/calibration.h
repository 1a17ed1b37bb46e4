/* passes/gather/calibration.h to its shaders. */
#ifndef SHARED_CALIBRATION_H
#define SHARED_CALIBRATION_H

#include "shared/types.h"

#define UNIT_CALIBRATION_TESTS (UNIT_OWN + 0)
#define UNIT_CALIBRATION_SUMS (UNIT_OWN + 1)
#define UNIT_CALIBRATION_SQUARES (UNIT_OWN + 2)

#define CALIBRATION_SIDE 8      /* cells of the picture, along either side */
#define CALIBRATION_TOGETHER 16 /* VPLs, of which one is asked for all */

struct calibration_params {
    int tests_of_cell;
    int vpl_count;
    int groups; /* of VPLs */
    int block;  /* of blocks that share visibility, pixels a side; 0: none do */
};
PASS_BLOCK(calibration_params, 16)

#endif
