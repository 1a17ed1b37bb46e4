/* passes/lights/vpl_weight.h to its shaders, and to those that read what it leaves. */
#ifndef SHARED_VPL_WEIGHT_H
#define SHARED_VPL_WEIGHT_H

#include "shared/types.h"

#define VPL_WEIGHT_POINTS 64 /* of the picture, that a VPL is asked about */

struct vpl_weight_params {
    int vpls;
    int unused0, unused1, unused2;
};
PASS_BLOCK(vpl_weight_params, 16)

#endif
