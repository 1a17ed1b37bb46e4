// A VPL as transform feedback captures it.
#include "lib/vpl_rows.glsl"

layout(xfb_buffer = 0, xfb_stride = 64) out;
layout(xfb_offset = 0) out vec4 captured_position_and_val;
layout(xfb_offset = 16) out vec4 captured_normal_and_area;
layout(xfb_offset = 32) out vec4 captured_flux_and_reach;
layout(xfb_offset = 48) out vec4 captured_lobe;

void vpl_output(vpl v) {
    captured_position_and_val = vec4(v.position, v.val);
    captured_normal_and_area = vec4(v.normal, v.area);
    captured_flux_and_reach = vec4(v.flux, v.reach);
    captured_lobe = vec4(v.to_light, v.alpha, v.lobe);
}
