// All VPLs, to be read by number.
#include "shared/vpl.h"

layout(binding = UNIT_VPLS) uniform samplerBuffer vpl_texels; // three of a VPL

vpl vpl_at(int i) {
    vec4 position_and_val = texelFetch(vpl_texels, 3 * i);
    vec4 normal_and_area = texelFetch(vpl_texels, 3 * i + 1);
    vec4 flux_and_reach = texelFetch(vpl_texels, 3 * i + 2);
    return vpl(position_and_val.xyz, position_and_val.w, normal_and_area.xyz, normal_and_area.w,
               flux_and_reach.rgb, flux_and_reach.w);
}
