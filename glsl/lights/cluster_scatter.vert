// Each VPL is a point that finds its nearest VAL and lands on that VAL's pixel, where additive blending
// sums up what belongs together [Dong 2009 §6].
#include "lights/val_distance.glsl"
#include "lib/vpl_input.glsl"

flat out vec3 point_position, point_normal, point_flux;

void main() {
    vpl v = vpl_input();
    point_position = v.position;
    point_normal = v.normal;
    point_flux = v.flux;
    gl_Position = v.reach > 0.0 ? val_pixel(nearest_val(v)) : vec4(0.0, 0.0, 2.0, 1.0);
}
