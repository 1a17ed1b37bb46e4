/* VPLs of each light, filled by passes/lights/vpl.h. */
#ifndef SHARED_VPL_SHARE_H
#define SHARED_VPL_SHARE_H

#include "shared/light.h"

struct vpl_share {
    /* Measure of one VPL: solid angle, sr; of a directional light area, m2. */
    float measure;
    float reach; /* reach of the near field, in spacings of VPLs */
    float unused0, unused1;
};
STD140_SIZE(vpl_share, 16)

/* Block BLOCK_VPL_SHARES. */
struct vpl_share_block {
    STRUCT(vpl_share) of[LIGHTS_MAX];
};
STD140_SIZE(vpl_share_block, LIGHTS_MAX * 16)

#endif
