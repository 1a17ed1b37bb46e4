// A VPL as a vertex.
#include "shared/vpl.h"

layout(location = ATTRIBUTE_VPL_POSITION) in vec4 position_and_val;
layout(location = ATTRIBUTE_VPL_NORMAL) in vec4 normal_and_area;
layout(location = ATTRIBUTE_VPL_FLUX) in vec4 flux_and_reach;

vpl vpl_input() {
    return vpl(position_and_val.xyz, position_and_val.w, normal_and_area.xyz, normal_and_area.w,
               flux_and_reach.rgb, flux_and_reach.w);
}
