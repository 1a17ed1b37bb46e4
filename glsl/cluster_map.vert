// The mapping C: each VPL is written again with the number of its VAL [Dong 2009 §6].
#include "lib/val_distance.glsl"

layout(location = ATTRIBUTE_VPL_POSITION) in vec4 position;
layout(location = ATTRIBUTE_VPL_NORMAL) in vec4 normal;
layout(location = ATTRIBUTE_VPL_FLUX) in vec4 flux;

out vec4 vpl_position, vpl_normal, vpl_flux;

void main() {
    vpl_position = vec4(position.xyz, float(nearest_val(position.xyz, normal.xyz)));
    vpl_normal = normal;
    vpl_flux = flux;
}
