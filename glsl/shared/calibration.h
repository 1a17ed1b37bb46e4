/* passes/gather/calibration.h to its shaders. */
#ifndef SHARED_CALIBRATION_H
#define SHARED_CALIBRATION_H

#include "shared/types.h"

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
