// A VPL as a vertex.
#include "lib/vpl_rows.glsl"

layout(location = ATTRIBUTE_VPL_POSITION) in vec4 position_and_val;
layout(location = ATTRIBUTE_VPL_NORMAL) in vec4 normal_and_area;
layout(location = ATTRIBUTE_VPL_FLUX) in vec4 flux_and_reach;
layout(location = ATTRIBUTE_VPL_LOBE) in vec4 lobe;

vpl vpl_input() {
    return vpl_of_rows(position_and_val, normal_and_area, flux_and_reach, lobe);
}
