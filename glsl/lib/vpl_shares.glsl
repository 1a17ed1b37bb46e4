#include "shared/vpl_share.h"

layout(std140, binding = BLOCK_VPL_SHARES) uniform vpl_share_uniforms {
    vpl_share_block vpl_shares;
};
