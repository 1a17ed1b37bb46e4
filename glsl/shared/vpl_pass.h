/* passes/lights/vpl.h to its shader. */
#ifndef SHARED_VPL_PASS_H
#define SHARED_VPL_PASS_H

#include "shared/types.h"

struct vpl_params {
    int count;
    int unused0, unused1, unused2;
};
PASS_BLOCK(vpl_params, 16)

#endif
