// Each VPL is a point that finds its nearest VAL and lands on that VAL's pixel, where additive blending
// sums up what belongs together [Dong 2009 §6].
#include "lib/val_distance.glsl"

layout(location = ATTRIBUTE_VPL_POSITION) in vec4 position;
layout(location = ATTRIBUTE_VPL_NORMAL) in vec4 normal;
layout(location = ATTRIBUTE_VPL_FLUX) in vec4 flux;

flat out vec3 point_position, point_normal, point_flux;

void main() {
    point_position = position.xyz;
    point_normal = normal.xyz;
    point_flux = flux.rgb;
    gl_PointSize = 1.0;
    bool emits = flux.w > 0.0;
    gl_Position = emits ? val_pixel(nearest_val(position.xyz, normal.xyz)) : vec4(0.0, 0.0, 2.0, 1.0);
}
