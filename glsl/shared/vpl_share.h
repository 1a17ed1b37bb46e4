/* How the VPLs are shared among the lights; passes/lights/vpl.h fills it. */
#ifndef SHARED_VPL_SHARE_H
#define SHARED_VPL_SHARE_H

#include "shared/light.h"

struct vpl_share {
    float measure; /* what one VPL of the light stands for: solid angle, sr; of a directional light's,
                      area, m2 */
    float reach;   /* of the near field, in spacings of VPLs */
    float unused0, unused1;
};
STD140_SIZE(vpl_share, 16)

/* At BLOCK_VPL_SHARES. */
struct vpl_share_block {
    STRUCT(vpl_share) of[LIGHTS_MAX];
};
STD140_SIZE(vpl_share_block, LIGHTS_MAX * 16)

#endif
