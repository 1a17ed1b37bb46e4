#include "shared/vpl_share.h"

layout(std140, binding = BLOCK_VPL_SHARES) uniform vpl_share_uniforms {
    vec4 vpl_share_rows[LIGHTS_MAX];
};

vpl_share vpl_share_at(int light) {
    return vpl_share(vpl_share_rows[light].x, vpl_share_rows[light].y, 0.0, 0.0);
}
